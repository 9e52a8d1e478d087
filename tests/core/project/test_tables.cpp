// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/struct_json.h"
#include "core/project/cycle.h"
#include "core/project/member.h"
#include "core/project/validate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "words/reference_page.h"

#include <cmath>
#include <regex>
#include <set>
#include <utility>

namespace sparkout::test_tables {

/// Units of the keys' endings, longer endings first.
const std::vector<std::pair<std::string, std::string>>& unitsOfEndings() {
    static const std::vector<std::pair<std::string, std::string>> all{
        {"_per_mm2", "1/mm²"}, {"_per_mm", "1/mm"}, {"_mm_per_n", "mm/N"}, {"_mm_min", "mm/min"},
        {"_n_um_at_n", ""},    {"_mm2_s", "mm²/s"}, {"_w_mk", "W/(m·K)"},  {"_j_m2", "J/m²"},
        {"_n_um", "N/µm"},     {"_m_s", "m/s"},     {"_rpm", "rev/min"},   {"_mpa", "MPa"},
        {"_gpa", "GPa"},       {"_deg", "°"},       {"_hrc", "HRC"},       {"_kw", "kW"},
        {"_kg", "kg"},         {"_um", "µm"},       {"_n_mm", "N/mm"},     {"_g_mm", "g·mm"},
        {"_mm_s", "mm/s"},     {"_hz", "Hz"},       {"_mm", "mm"},         {"_s", "s"},
        {"_m_k", "10⁻⁶/K"},    {"_k", "K"}};
    return all;
}

bool isNumeric(Kind kind) {
    switch (kind) {
    case Kind::boolean:
    case Kind::text:
    case Kind::choice:
    case Kind::object:
    case Kind::optionalObject:
    case Kind::objectList:
    case Kind::jsonText: return false;
    default: return true;
    }
}

bool isNullable(Kind kind) {
    switch (kind) {
    case Kind::optionalNumber:
    case Kind::optionalInteger:
    case Kind::optionalNumberList:
    case Kind::optionalObject:
    case Kind::countOrWord:
    case Kind::compliance:
    case Kind::levels:
    case Kind::numberRows: return true;
    default: return false;
    }
}

std::set<std::string> sourceKeys() {
    std::set<std::string> keys;
    std::istringstream lines(samples::readText(samples::sourcePath("core/SOURCES.md")));
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, std::regex("^(?:## |\\| )([A-Z]+-?[0-9]*)"))) {
            keys.insert(match[1]);
        }
    }
    std::istringstream model(samples::readText(samples::sourcePath("core/MODEL.md")));
    for (std::string line; std::getline(model, line);) {
        std::smatch match;
        if (std::regex_search(line, match, std::regex("^## ([0-9]+)\\."))) {
            keys.insert("MODEL-" + match[1].str());
        }
    }
    return keys;
}

class TestTables : public QObject {
    Q_OBJECT

private slots:
    void everyRow_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < samples::places().size(); ++i) {
            QTest::newRow(samples::places()[i].path.c_str()) << static_cast<int>(i);
        }
    }

    void everyRow() {
        QFETCH(int, index);
        const samples::Place& place = samples::places()[static_cast<std::size_t>(index)];
        checkTexts(*place.field);
        checkUnit(*place.field);
        checkRanges(*place.field);
        checkDefault(*place.table, *place.field);
        checkSource(*place.field);
        checkConditions(*place.table, *place.field);
    }

    void keysAreUniqueInATable() {
        std::set<const StructInfo*> seen;
        for (const samples::Place& place : samples::places()) {
            std::set<std::string> keys;
            if (seen.insert(place.table).second) {
                for (const Field& field : place.table->fields) {
                    QVERIFY2(keys.insert(field.key).second, field.key);
                    QCOMPARE(place.table->find(field.key), &field);
                }
                QVERIFY(*place.table->name);
                QCOMPARE(place.table->find("no_such_key"), nullptr);
            }
        }
    }

    void itemsOfAListAreFoundInsertedSwappedAndErased() {
        Cycle cycle;
        for (const double stock_mm : {0.1, 0.2}) {
            cycle.stages.emplace_back().stock_mm = stock_mm;
        }
        const Field& stages = *tableOf<Cycle>().find("stages");
        stages.insert(&cycle, 2);
        stages.insert(&cycle, 0);
        QCOMPARE(cycle.stages.size(), std::size_t(4));
        QCOMPARE(cycle.stages[3].stock_mm, 0.2); // as the one before it
        QCOMPARE(cycle.stages[0].stock_mm, Stage{}.stock_mm);
        stages.erase(&cycle, 0);
        cycle.stages[2].stock_mm = 0.3;
        stages.swap(&cycle, 0, 2);
        stages.erase(&cycle, 1);
        QCOMPARE(cycle.stages.size(), std::size_t(2));
        QCOMPARE(cycle.stages[0].stock_mm, 0.3);
        const void* const root = &cycle;
        const ConstMember last = memberIn(tableOf<Cycle>(), root, "/stages/1/stock_mm");
        QVERIFY(last.owner == &cycle.stages[1] && last.field->as<double>(last.owner) == 0.1);
        QVERIFY(!memberIn(tableOf<Cycle>(), root, "/stages/2/stock_mm"));
        // What is below a struct that is not given is not there, and reading does not create it.
        Project project;
        project.batch.reset();
        const void* const whole = &project;
        QVERIFY(!memberIn(tableOf<Project>(), whole, "/batch/parts") && !project.batch);
        QVERIFY(findMember(std::as_const(project), "/batch/parts"));
    }

    void defaultsAreUsual() {
        Project project;
        for (const samples::Spot& spot : samples::spots(project)) {
            if (spot.field->kind == Kind::number) {
                const double value = spot.field->as<double>(spot.owner);
                QVERIFY2(spot.field->soft.contains(value) || spot.field->required,
                         spot.path.c_str());
            }
        }
    }

private:
    static void checkTexts(const Field& field) {
        QVERIFY(*field.label);
        QVERIFY2(field.nested || *field.hint, "a hint is missing");
        QVERIFY2(!*field.hint || std::string(field.hint).back() == '.', "a hint is a sentence");
        QCOMPARE(*field.nullMeaning != '\0', isNullable(field.kind));
        QVERIFY(std::regex_match(field.key, std::regex("[a-z][a-z0-9_]*")));
        std::set<std::string> keys;
        for (const Choice& choice : field.choices) {
            QVERIFY(keys.insert(choice.key).second);
            QVERIFY(*choice.label);
        }
        QCOMPARE(field.kind == Kind::choice, keys.size() > 1);
    }

    static void checkUnit(const Field& field) {
        if (!isNumeric(field.kind) || std::string(field.key) == "n_um_at_n") {
            return;
        }
        for (const auto& [ending, unit] : unitsOfEndings()) {
            if (std::string(field.key).ends_with(ending)) {
                const bool feed = field.unit == unit + "/dbl stroke"; // of traverse grinding
                QVERIFY2(field.unit == unit || feed, field.unit);
                return;
            }
        }
    }

    static void checkRanges(const Field& field) {
        const Range& hard = field.hard;
        const Range& soft = field.soft;
        if (isNumeric(field.kind)) {
            QVERIFY2(std::isfinite(hard.low) && std::isfinite(hard.high), "no hard range");
            QVERIFY(hard.low < hard.high);
        }
        if (!soft.unbounded()) {
            QVERIFY(soft.low < soft.high);
            QVERIFY2(hard.contains(soft.low) && hard.contains(soft.high),
                     "the usual range leaves the allowed one");
        }
        const bool whole = field.kind == Kind::integer || field.kind == Kind::optionalInteger
                           || field.kind == Kind::countOrWord || field.kind == Kind::objectList;
        if (whole && !hard.unbounded()) {
            QVERIFY(hard.low == std::floor(hard.low) && hard.high == std::floor(hard.high));
            QVERIFY(hard.low >= -2147483647.0 && hard.high <= 2147483647.0);
        }
    }

    static void checkDefault(const StructInfo& table, const Field& field) {
        if (field.kind == Kind::number) {
            QVERIFY(field.hard.contains(field.as<double>(table.defaults)) || field.required);
        } else if (field.kind == Kind::integer) {
            QVERIFY(field.hard.contains(field.as<int>(table.defaults)));
        } else if (field.kind == Kind::numberList) {
            for (const double value : field.as<std::vector<double>>(table.defaults)) {
                QVERIFY(field.hard.contains(value));
            }
        }
        if (isNullable(field.kind)) { // only what is null by default may be left out when null
            QVERIFY(!writeByTable(table, table.defaults).contains(field.key));
        }
    }

    static void checkSource(const Field& field) {
        static const std::set<std::string> keys = sourceKeys();
        QVERIFY2(!*field.source || keys.count(field.source) == 1, field.source);
    }

    static void checkConditions(const StructInfo& table, const Field& field) {
        for (const Condition condition : {field.required, field.relevant}) {
            if (condition) {
                QVERIFY(conditionText(condition, table) != "never");
            }
        }
        if (field.relevant) {
            QVERIFY(conditionText(field.relevant, table) != "always");
        }
    }
};

} // namespace sparkout::test_tables

SPARKOUT_TEST(test_tables, TestTables)
#include "test_tables.moc"
