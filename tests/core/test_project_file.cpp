// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"
#include "core/project/table_reader.h"
#include "core/project/validate.h"
#include "tests/core/project_mutator.h"
#include "tests/core/project_samples.h"
#include "tests/core/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace test_project_file {

using namespace sparkout;
using nlohmann::json;
using samples::fromSeed;
using samples::holds;
using samples::Mutator;

namespace {

/// Which rows have been seen away from their defaults, and in which forms.
class Coverage {
public:
    void add(Project& project) {
        m_written.clear();
        for (const samples::Spot& spot : samples::spots(project)) {
            const json value = valueOf(*spot.table, spot.owner, *spot.field);
            if (value != valueOf(*spot.table, spot.table->defaults, *spot.field)) {
                m_seen.insert(spot.place);
            }
            if (spot.field->kind == Kind::compliance || spot.field->kind == Kind::levels
                || spot.field->kind == Kind::sparkOut) {
                m_seen.insert(spot.place + " " + value.type_name());
            }
        }
    }

    std::string missing() const {
        std::string text;
        for (const samples::Place& place : samples::places()) {
            for (const char* form : formsOf(*place.field)) {
                const std::string name = place.path + form;
                text += m_seen.count(name) ? "" : name + '\n';
            }
        }
        return text;
    }

private:
    static std::vector<const char*> formsOf(const Field& field) {
        switch (field.kind) {
        case Kind::object: return {}; // its members count
        case Kind::compliance:
        case Kind::levels: return {"", " null", " array", " object"};
        case Kind::sparkOut: return {"", " null", " number", " string"};
        default: return {""};
        }
    }

    json valueOf(const StructInfo& table, const void* owner, const Field& field) {
        auto& object = m_written[{&table, owner}];
        if (object.is_null()) {
            object = writeByTable(table, owner);
        }
        const auto found = object.find(field.key);
        return found == object.end() ? json(nullptr) : json(*found);
    }

    std::set<std::string> m_seen;
    std::map<std::pair<const StructInfo*, const void*>, nlohmann::ordered_json> m_written;
};

/// The text a written project reads back to, checked; empty when all is well.
std::string roundTripFault(const Project& project) {
    const std::string text = writeProject(project);
    const ReadResult read = readProject(text);
    if (!read.project) {
        return "refused: " + samples::listed(read.issues) + text;
    }
    if (!sameProject(project, *read.project)) {
        return "another project: " + text;
    }
    return writeProject(*read.project) == text ? "" : "other bytes: " + text;
}

/// Eight values of wrong type for a kind.
std::vector<json> wrongValues(Kind kind) {
    const json object = {{"x", 1}};
    switch (kind) {
    case Kind::number:
        return {nullptr, true, "", "7", "text", json::array(), json::object(), object};
    case Kind::optionalNumber:
        return {true, false, "", "7", json::array(), json{7}, json::object(), object};
    case Kind::integer: return {nullptr, true, 1.5, "7", "", json::array(), json{7}, object};
    case Kind::optionalInteger: return {true, 1.5, "7", "", json::array(), json{7}, false, object};
    case Kind::boolean: return {nullptr, 0, 1, "true", "", json::array(), json{true}, object};
    case Kind::text:
    case Kind::choice:
        return {nullptr, true, 0, 1.5, json::array(), json{"a"}, json::object(), object};
    case Kind::numberList:
        return {nullptr, true, 1, "1", json{"1"}, json{nullptr}, json{json{1}}, object};
    case Kind::optionalNumberList:
    case Kind::numberRows:
        return {false, true, 1, "1", json{"1"}, json{nullptr}, json{json{"1"}}, object};
    case Kind::object:
        return {nullptr, true, 0, 1.5, "", json::array(), json{json::object()}, object};
    case Kind::optionalObject:
        return {false, true, 0, 1.5, "", json::array(), json{json::object()}, object};
    case Kind::objectList:
        return {nullptr, true, 0, "", json{1}, json{nullptr}, json{json::array()}, object};
    case Kind::sparkOut: return {true, false, 1.5, "5", "none", json::array(), json{5}, object};
    case Kind::compliance:
        return {true, 1e-4, "1e-4", json{"1"}, json{nullptr}, json{true}, json::object(), object};
    case Kind::levels:
        return {true,
                1,
                "1",
                json{"1"},
                json{nullptr},
                json{json{1}},
                json::object(),
                json{{"from", 0.1}, {"to", "x"}, {"step", 1}}};
    case Kind::jsonText: return {nullptr, true, 0, 1.5, "{}", json::array(), json{1}, ""};
    }
    return {};
}

/// Paths of the numbers a row may hold, relative to it, with what to put around each.
std::vector<std::pair<std::string, std::function<json(double)>>> numbersOf(const Field& field) {
    const auto list = [count = field.count](double x) {
        return json(std::vector<double>(count ? count : 4, x));
    };
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
    case Kind::sparkOut: return {{"", [](double x) { return json(x); }}};
    case Kind::numberList:
    case Kind::optionalNumberList: return {{"/0", list}};
    case Kind::compliance:
        return {{"/0", list}, {"/nz", [](double x) {
                                   return json{{"rz1", 1e-5}, {"nz", x}, {"rz2", 1e-5}};
                               }}};
    case Kind::levels:
        return {{"/0", list}, {"/step", [](double x) {
                                   return json{{"from", 0.5}, {"to", 0.5}, {"step", x}};
                               }}};
    case Kind::numberRows: return {{"/0/0", [=](double x) { return json{list(x)}; }}};
    default: return {};
    }
}

} // namespace

class TestProjectFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(1000); }

    // --- round trip (reliability check 4) -------------------------------------------------------

    void samplesReadWithoutErrorAndRoundTrip_data() { sampleRows(); }
    void samplesReadWithoutErrorAndRoundTrip() {
        QFETCH(QString, name);
        const ReadResult read = readProject(samples::text(name.toStdString()));
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const std::string fault = roundTripFault(*read.project);
        QVERIFY2(fault.empty(), fault.c_str());
    }

    void completeExampleKeepsEveryValue() {
        const json given = samples::sample("complete").flatten();
        const json written = json::parse(writeProject(samples::project("complete"))).flatten();
        for (const auto& [path, value] : given.items()) {
            if (!value.is_null()) {
                QVERIFY2(written.value(path, json()) == value, path.c_str());
            }
        }
    }

    void everythingGivesEveryKeyOfTheTables() {
        Project project = samples::project("everything");
        std::set<std::string> given;
        for (const samples::Spot& spot : samples::spots(project)) {
            given.insert(spot.place);
        }
        for (const samples::Place& place : samples::places()) {
            QVERIFY2(given.count(place.path), place.path.c_str());
        }
    }

    void everyLeafRoundTripsAwayFromItsDefault() {
        Coverage coverage;
        const auto lastSeed = static_cast<std::uint64_t>(samples::sized(4, 0, 4));
        const auto step = static_cast<std::size_t>(samples::sized(1, 6, 1));
        for (const std::string& name : samples::names()) {
            Project project = samples::project(name);
            coverage.add(project);
            const std::size_t count = samples::spots(project).size();
            for (std::size_t i = 0; i < count; i += step) {
                for (std::uint64_t seed = 0; seed < 12; ++seed) {
                    Project changed = samples::project(name);
                    Mutator mutator(fromSeed(seed + 977 * i));
                    if (mutator.mutateOne(changed, samples::spots(changed)[i])) {
                        coverage.add(changed);
                        const std::string fault = roundTripFault(changed);
                        QVERIFY2(fault.empty(), fault.c_str());
                        if (seed > lastSeed) {
                            break;
                        }
                    }
                }
            }
        }
        if (step == 1) {
            QCOMPARE(coverage.missing(), std::string());
        }
    }

    void randomProjectsRoundTripByteForByte() {
        Coverage coverage;
        QVERIFY(rc::check("write, read, write", [&] {
            Project project = samples::project(*rc::gen::elementOf(samples::names()));
            Mutator mutator(fromSeed(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())));
            mutator.mutate(project, 60);
            coverage.add(project);
            const std::string fault = roundTripFault(project);
            if (!fault.empty()) {
                RC_FAIL(fault);
            }
        }));
        if (!std::getenv("SPARKOUT_QUICK")) {
            QCOMPARE(coverage.missing(), std::string());
        }
    }

    void texts_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("cyrillic") << QByteArray("Вал 30h6, круг 25А F60 L 6 V");
        QTest::newRow("four bytes") << QByteArray("𝛾 = 🛠 𠜎");
        QTest::newRow("quotes and slashes") << QByteArray(R"("\/ {value} {limit} %1 </b>)");
        QTest::newRow("control characters") << QByteArray("a\0b\x01\x1f\x7f\n\r\t", 9);
        QTest::newRow("direction marks") << QByteArray("\u202egnp.exe\u2066 \u2028");
        QTest::newRow("64 KB") << QByteArray(65536, 'x');
    }
    void texts() {
        QFETCH(QByteArray, text);
        Project project = samples::project("smallest-traverse");
        project.title = text.toStdString();
        project.runs = {{text.toStdString(),
                         "",
                         "",
                         {samples::text("smallest-plunge")},
                         {json{{text.left(60).toStdString(), text.toStdString()}}.dump()}}};
        const std::string fault = roundTripFault(project);
        QVERIFY2(fault.empty(), fault.substr(0, 500).c_str());
    }

    void numbers_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<double>("value");
        QTest::addColumn<QByteArray>("again");
        QTest::newRow("shortest") << QByteArray("0.1") << 0.1 << QByteArray("0.1");
        QTest::newRow("sum") << QByteArray("0.30000000000000004") << 0.1 + 0.2
                             << QByteArray("0.30000000000000004");
        QTest::newRow("too many digits")
            << QByteArray("0.1000000000000000055511") << 0.1 << QByteArray("0.1");
        QTest::newRow("tiny") << QByteArray("1e-300") << 1e-300 << QByteArray("1e-300");
        QTest::newRow("denormal") << QByteArray("5e-324") << 5e-324 << QByteArray("5e-324");
        QTest::newRow("below everything") << QByteArray("1e-400") << 0.0 << QByteArray("0");
        QTest::newRow("minus zero") << QByteArray("-0") << 0.0 << QByteArray("0");
        QTest::newRow("minus zero, float") << QByteArray("-0.0") << 0.0 << QByteArray("0");
        QTest::newRow("whole float") << QByteArray("36.0") << 36.0 << QByteArray("36");
        QTest::newRow("exponent") << QByteArray("1e3") << 1000.0 << QByteArray("1000");
        QTest::newRow("capital exponent") << QByteArray("1.5E+1") << 15.0 << QByteArray("15");
    }
    void numbers() {
        QFETCH(QByteArray, written);
        QFETCH(double, value);
        QFETCH(QByteArray, again);
        std::string text = samples::text("smallest-traverse");
        const std::string key = "\"dwell_exit_s\": ";
        const std::size_t at = text.find(key + "0");
        QVERIFY(at != std::string::npos);
        text.replace(at + key.size(), 1, written.toStdString());
        const ReadResult read = readProject(text);
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        QCOMPARE(read.project->machine.dwell_exit_s, value);
        QVERIFY(!std::signbit(read.project->machine.dwell_exit_s));
        const std::string out = writeProject(*read.project);
        QVERIFY(out.find(key + again.toStdString() + ",") != std::string::npos);
        const std::string fault = roundTripFault(*read.project);
        QVERIFY2(fault.empty(), fault.c_str());
    }

    void wholeNumbersMayBeWrittenAsNumbers() {
        for (const char* written : {"36", "36.0", "3.6e1", "360e-1"}) {
            json file = samples::sample("smallest-traverse");
            file["part"]["radii_per_section"] = json::parse(written);
            QCOMPARE(readProject(file.dump()).project.value().part.radii_per_section, 36);
        }
    }

    void minusZeroInMemoryIsWrittenAsZero() {
        Project project = samples::project("smallest-traverse");
        project.machine.dwell_exit_s = -0.0;
        project.runs = {{"", "", "", {samples::text("smallest-plunge")}, {R"({"x": -0.0})"}}};
        QCOMPARE(roundTripFault(project), std::string());
    }

    void keptRunKeepsItsValuesAndCanonicalOrder() {
        json file = samples::sample("everything");
        file["runs"][0]["summary"] = json::parse(
            R"({"b": [1, 2.5, "x", null, {"deep": true}], "a": 9007199254740993, "c": 1e22})");
        const ReadResult read = readProject(file.dump());
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const json written = json::parse(writeProject(*read.project));
        QVERIFY(written["runs"][0]["summary"] == file["runs"][0]["summary"]);
        QVERIFY(written["runs"][0]["inputs"] == file["runs"][0]["inputs"]);
        Project unordered = *read.project;
        unordered.runs[0].summary.text = R"({"z": 1, "a": {"y": 2, "b": 3}})";
        QCOMPARE(roundTripFault(unordered), std::string());
    }

    // --- required keys --------------------------------------------------------------------------

    void missingRequiredKeyIsNamed_data() { sampleRows(); }
    void missingRequiredKeyIsNamed() {
        QFETCH(QString, name);
        const json whole = samples::sample(name.toStdString());
        Project project = samples::project(name.toStdString());
        int removed = 0;
        for (const samples::Spot& spot : samples::spots(project)) {
            const json::json_pointer pointer(spot.path);
            if (!whole.contains(pointer) || spot.field->kind == Kind::object) {
                continue;
            }
            json file = whole;
            file[pointer.parent_pointer()].erase(pointer.back());
            const Issues issues = samples::faults(file);
            const bool required = spot.field->required && spot.field->required(project, spot.owner);
            QVERIFY2(holds(issues, IssueCode::missingKey, spot.path) == required,
                     spot.path.c_str());
            removed += required ? 1 : 0;
            if (required) {
                QVERIFY2(!samples::find(issues, spot.path)->limit.empty(), spot.path.c_str());
            }
        }
        QVERIFY(removed >= 13);
    }

    void missingObjectNamesItsRequiredMembers() {
        json file = samples::sample("smallest-traverse");
        file.erase("wheel");
        const Issues issues = samples::faults(file);
        for (const char* path : {"/wheel/diameter_mm", "/wheel/width_mm", "/wheel/dullness"}) {
            QVERIFY(holds(issues, IssueCode::missingKey, path));
        }
        QCOMPARE(issues.size(), std::size_t{3});
    }

    void traverseKeysAreNotAskedOfAPlungeCycle() {
        QVERIFY(readProject(samples::text("smallest-plunge")).issues.empty());
        json file = samples::sample("smallest-traverse");
        for (const char* key : {"plunge_feed_mm_min", "overrun_entry_mm", "overrun_exit_mm",
                                "dwell_entry_s", "dwell_exit_s"}) {
            file["machine"].erase(key);
            QVERIFY(holds(samples::faults(file), IssueCode::missingKey,
                          std::string("/machine/") + key));
        }
    }

    void withoutAnOperationOnlyCertainFaultsAreNamed() {
        for (const json& operation : {json(nullptr), json(1), json("drilling")}) {
            json file = samples::sample("smallest-plunge");
            file["operation"] = operation;
            file["wheel"]["width_mm"] = -1;
            const Issues issues = samples::faults(file);
            QVERIFY2(issues.size() == 2, samples::listed(issues).c_str());
            QCOMPARE(issues[0].path, std::string("/operation"));
            QCOMPARE(issues[1].path, std::string("/wheel/width_mm"));
        }
    }

    // --- wrong types, ranges, keys --------------------------------------------------------------

    void wrongTypesAreRefused_data() { placeRows(); }
    void wrongTypesAreRefused() {
        QFETCH(int, index);
        const samples::Place& place = samples::places()[static_cast<std::size_t>(index)];
        const std::string path = pathInEverything(place);
        const auto wrong = wrongValues(place.field->kind);
        QCOMPARE(wrong.size(), std::size_t{8});
        const auto step = static_cast<std::size_t>(samples::sized(1, 4, 1));
        for (std::size_t i = static_cast<std::size_t>(index) % step; i < wrong.size(); i += step) {
            const json& value = wrong[i];
            json file = samples::sample("everything");
            file[json::json_pointer(path)] = value;
            const ReadResult read = readProject(file.dump());
            QVERIFY2(!read.project, value.dump().c_str());
            const bool named =
                std::any_of(read.issues.begin(), read.issues.end(), [&](const Issue& issue) {
                    return issue.severity == Severity::error && issue.path.starts_with(path);
                });
            QVERIFY2(named, (value.dump() + "\n" + samples::listed(read.issues)).c_str());
        }
    }

    void rangesHoldAtTheirLimits_data() { placeRows(); }
    void rangesHoldAtTheirLimits() {
        QFETCH(int, index);
        const samples::Place& place = samples::places()[static_cast<std::size_t>(index)];
        const Range& hard = place.field->hard;
        const bool whole = place.field->kind == Kind::integer || place.field->kind == Kind::sparkOut
                           || place.field->kind == Kind::optionalInteger;
        const double infinity = std::numeric_limits<double>::infinity();
        const auto above = [&](double x) { return whole ? x + 1 : std::nextafter(x, infinity); };
        const auto below = [&](double x) { return whole ? x - 1 : std::nextafter(x, -infinity); };
        for (const auto& [item, around] : numbersOf(*place.field)) {
            const std::string path = pathInEverything(place);
            const auto refuses = [&, put = around, at = path + item](double x) {
                json file = samples::sample("everything");
                file[json::json_pointer(path)] = put(x);
                const Issues issues = samples::faults(file);
                return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) {
                    return issue.code == IssueCode::outOfRange && issue.path == at
                           && issue.limit == rangeText(hard, place.field->unit)
                           && issue.value.starts_with(numberText(x));
                });
            };
            QVERIFY(!refuses(hard.high));
            QVERIFY(refuses(above(hard.high)));
            QVERIFY(refuses(1e300));
            QVERIFY(refuses(-1e300));
            QCOMPARE(refuses(hard.low), hard.lowOpen);
            QVERIFY(refuses(below(hard.low)));
            QVERIFY(!refuses(above(hard.low)));
        }
    }

    void unusualValuesWarnAndDoNotRefuse_data() { placeRows(); }
    void unusualValuesWarnAndDoNotRefuse() {
        QFETCH(int, index);
        const samples::Place& place = samples::places()[static_cast<std::size_t>(index)];
        if (place.field->soft.unbounded()) {
            return;
        }
        const std::string path = pathInEverything(place);
        const Range& soft = place.field->soft;
        Project project = samples::project("everything");
        const auto all = samples::spots(project);
        const auto spot =
            std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.path == path; });
        const bool used = !place.field->relevant || place.field->relevant(project, spot->owner);
        const auto numbers = numbersOf(*place.field);
        for (const auto& [item, around] : numbers) {
            const auto faultAt = [&, put = around, at = path + item](double x) {
                json file = samples::sample("everything");
                file[json::json_pointer(path)] = put(x);
                const Issues issues = samples::faults(file);
                const Issue* issue = samples::find(issues, at);
                return issue ? std::optional(*issue) : std::nullopt;
            };
            for (const double limit : {soft.low, soft.high}) {
                const auto fault = faultAt(limit);
                QVERIFY(!fault || fault->code != IssueCode::unusual);
            }
            const double beyond = (soft.high + place.field->hard.high) / 2;
            if (beyond > soft.high && used && place.field->kind != Kind::integer) {
                const auto fault = faultAt(beyond);
                QVERIFY2(fault, "a value beyond the usual range passes in silence");
            }
        }
    }

    void unknownKeyIsNamedAtEveryLevel() {
        const json whole = samples::sample("everything");
        Project project = samples::project("everything");
        std::set<std::string> objects{""};
        for (const samples::Spot& spot : samples::spots(project)) {
            if (spot.path.find("/runs/0/") == std::string::npos) {
                objects.insert(json::json_pointer(spot.path).parent_pointer().to_string());
            }
        }
        objects.insert("/machine/compliance_mm_per_n");
        for (const std::string& path : objects) {
            json file = whole;
            file[json::json_pointer(path)]["colour"] = "white";
            const Issues issues = samples::faults(file);
            QVERIFY2(holds(issues, IssueCode::unknownKey, path + "/colour"), path.c_str());
            const Issue issue = *samples::find(issues, path + "/colour");
            QCOMPARE(issue.value, std::string("\"colour\""));
            QVERIFY2(!issue.limit.empty(), path.c_str());
        }
        QVERIFY(objects.size() > 20);
    }

    void hostileKeysAreEscapedInThePath() {
        json file = samples::sample("smallest-plunge");
        file["part"]["a/b~c\x1b[2J\u202e"] = 1;
        file["part"][std::string(60'000, 'k')] = 1;
        const Issues issues = samples::faults(file);
        QCOMPARE(issues.size(), std::size_t{2});
        QCOMPARE(issues[0].path, std::string("/part/a~1b~0c\\u001B[2J\\u202E"));
        QVERIFY(issues[1].path.size() < 100);
        QVERIFY(issues[1].value.size() < 100);
    }

    // --- every code -----------------------------------------------------------------------------

    void everyCode_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("warning");
        QTest::addColumn<QString>("path");
        fileRows();
        partRows();
        cycleRows();
    }
    void everyCode() {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(bool, warning);
        QFETCH(QString, path);
        const ReadResult read = readProject(text.toStdString());
        const std::string at = path.toStdString();
        const auto expected = static_cast<IssueCode>(code);
        QVERIFY2(holds(read.issues, expected, at), samples::listed(read.issues).c_str());
        for (const Issue& issue : read.issues) {
            if (issue.code == expected && issue.path == at) {
                QCOMPARE(issue.severity == Severity::warning, warning);
                const std::string sentence = fillTemplate(issueTemplate(issue.code), issue);
                QVERIFY(!sentence.empty());
                QVERIFY2(sentence.find("  ") == std::string::npos && !sentence.ends_with(' ')
                             && !sentence.ends_with(": "),
                         sentence.c_str());
            }
        }
        QCOMPARE(read.project.has_value(), !hasErrors(read.issues));
        if (!warning) {
            QVERIFY(!read.project);
        }
        m_produced.insert(expected);
    }

    void everyCodeHasASentenceAndIsProduced() {
        for (int i = 0; i <= static_cast<int>(IssueCode::targetOutsideField); ++i) {
            QVERIFY2(*issueTemplate(static_cast<IssueCode>(i)), std::to_string(i).c_str());
            QVERIFY2(m_produced.count(static_cast<IssueCode>(i)), std::to_string(i).c_str());
        }
    }

    void aValueMayHoldThePlacesOfATemplate() {
        const Issue issue{IssueCode::outOfRange, Severity::error, "", "{limit}", "{value}"};
        QCOMPARE(fillTemplate("{value} and {limit}", issue), std::string("{limit} and {value}"));
    }

    // --- all faults at once ---------------------------------------------------------------------

    void allFaultsAreNamedAtOnce() {
        std::string text = samples::text("smallest-traverse");
        json file = json::parse(text);
        file["colour"] = 1;
        file["title"] = 1;
        file["part"]["length_mm"] = -1;
        file["part"]["profile"] = "square";
        file["part"].erase("stock_mm");
        file["part"]["lower_deviation_um"] = 5;
        file["machine"]["overrun_entry_mm"] = 50;
        file["gauge"] = {{"commands", 9}};
        file["cycle"]["stages"][0]["radial_feed_mm"] = 0;
        text = file.dump();
        text.insert(text.rfind('}'), R"(,"author":"a","author":"b")");
        const Issues issues = readProject(text).issues;
        const std::vector<std::pair<IssueCode, std::string>> expected{
            {IssueCode::duplicateKey, "/author"},
            {IssueCode::unknownKey, "/colour"},
            {IssueCode::wrongType, "/title"},
            {IssueCode::notOneOf, "/part/profile"},
            {IssueCode::missingKey, "/part/stock_mm"},
            {IssueCode::outOfRange, "/part/length_mm"},
            {IssueCode::outOfRange, "/gauge/commands"},
            {IssueCode::deviationsReversed, "/part/lower_deviation_um"},
            {IssueCode::outOfRange, "/machine/overrun_entry_mm"},
            {IssueCode::feedMissing, "/cycle/stages/0/radial_feed_mm"}};
        for (const auto& [code, path] : expected) {
            QVERIFY2(holds(issues, code, path), (path + "\n" + samples::listed(issues)).c_str());
        }
    }

    void oneFaultIsNamedOnce() {
        json file = samples::sample("smallest-traverse");
        file["cycle"]["stages"][0]["radial_feed_mm"] = -1;
        file["part"]["radii_per_section"] = 361;
        const Issues issues = samples::faults(file);
        QVERIFY2(issues.size() == 2, samples::listed(issues).c_str());
    }

    void errorsAreNotLostBehindWarnings() {
        json file = samples::sample("smallest-traverse");
        json stage = file["cycle"]["stages"][0];
        stage["radial_feed_mm"] = 0.9; // unusual
        stage["stock_mm"] = 0.001;
        file["cycle"]["stages"] = std::vector<json>(900, stage);
        file["cycle"]["stages"][899]["radial_feed_mm"] = 0;
        const ReadResult read = readProject(file.dump());
        QVERIFY(!read.project);
        QVERIFY(holds(read.issues, IssueCode::feedMissing, "/cycle/stages/899/radial_feed_mm"));
        QCOMPARE(read.issues.size(), limits::issues);
    }

    void faultsOfAKeptRunCarryItsPath() {
        json file = samples::sample("everything");
        file["runs"][0]["inputs"]["wheel"]["width_mm"] = -1;
        file["runs"][0]["inputs"]["part"].erase("length_mm");
        file["runs"].push_back(file["runs"][0]);
        file["runs"][1]["inputs"] = json::object();
        const Issues issues = samples::faults(file);
        QVERIFY(holds(issues, IssueCode::outOfRange, "/runs/0/inputs/wheel/width_mm"));
        QVERIFY(holds(issues, IssueCode::missingKey, "/runs/0/inputs/part/length_mm"));
        QVERIFY(holds(issues, IssueCode::missingKey, "/runs/1/inputs/format"));
    }

private:
    static void sampleRows() {
        QTest::addColumn<QString>("name");
        for (const std::string& name : samples::names()) {
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
        }
    }

    static void placeRows() {
        QTest::addColumn<int>("index");
        const auto step = std::size_t(samples::sized(1, 3, 1));
        for (std::size_t i = 0; i < samples::places().size(); i += step) {
            QTest::newRow(samples::places()[i].path.c_str()) << static_cast<int>(i);
        }
    }

    /// The row in the sample "everything": the first item of each list.
    static std::string pathInEverything(const samples::Place& place) {
        std::string path = place.path;
        for (std::size_t star; (star = path.find('*')) != std::string::npos;) {
            path[star] = '0';
        }
        return path;
    }

    using Changes = std::vector<std::pair<std::string, json>>;

    static void row(const char* name, IssueCode code, const std::string& path,
                    const std::string& text, Severity severity = Severity::error) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << static_cast<int>(code)
                            << (severity == Severity::warning) << QString::fromStdString(path);
    }

    /// A row that changes a sample; a null value stands as null.
    static void row(const char* name, IssueCode code, const std::string& path,
                    const char* sampleName, const Changes& changes,
                    Severity severity = Severity::error) {
        json file = samples::sample(sampleName);
        for (const auto& [pointer, value] : changes) {
            file[json::json_pointer(pointer)] = value;
        }
        row(name, code, path, file.dump(), severity);
    }

    static void fileRows() {
        const char* plunge = "smallest-plunge";
        const std::string good = samples::text(plunge);
        std::string twice = good;
        twice.insert(twice.find("\"width_mm\""), "\"width_mm\": 50,");
        row("no text", IssueCode::empty, "", std::string());
        row("blank text", IssueCode::empty, "", std::string(" \r\n\t "));
        row("not JSON", IssueCode::notJson, "", good + "}");
        row("too large", IssueCode::tooLarge, "", good + std::string(limits::fileBytes, ' '));
        row("too deep", IssueCode::tooDeep, "",
            std::string(limits::depth + 1, '[') + std::string(limits::depth + 1, ']'));
        std::string many = "[0";
        for (std::size_t i = 0; i < limits::values; ++i) {
            many += ",0";
        }
        row("too many values", IssueCode::tooManyValues, "", many + "]");
        row("string too long", IssueCode::stringTooLong, "/title", plunge,
            {{"/title", std::string(limits::stringBytes + 1, 'x')}});
        row("string too long in a list", IssueCode::stringTooLong, "/cycle/stages/1", plunge,
            {{"/cycle/stages/1", std::string(limits::stringBytes + 1, 'x')}});
        row("wrong format", IssueCode::wrongFormat, "/format", plunge, {{"/format", "openrocket"}});
        row("newer version", IssueCode::newerVersion, "/version", plunge, {{"/version", 2}});
        row("much newer version", IssueCode::newerVersion, "/version", plunge,
            {{"/version", 18446744073709551615U}});
        row("version 0", IssueCode::outOfRange, "/version", plunge, {{"/version", 0}});
        row("version as text", IssueCode::wrongType, "/version", plunge, {{"/version", "1"}});
        row("duplicate key", IssueCode::duplicateKey, "/wheel/width_mm", twice);
        row("unknown key", IssueCode::unknownKey, "/wheel/widht_mm", plunge,
            {{"/wheel/widht_mm", 50}});
        row("missing key", IssueCode::missingKey, "/operation",
            R"({"format": "sparkout-project", "version": 1})");
        row("wrong type", IssueCode::wrongType, "/title", plunge, {{"/title", nullptr}});
        row("whole number beyond int", IssueCode::outOfRange, "/part/radii_per_section", plunge,
            {{"/part/radii_per_section", 4294967332LL}});
        row("not one of", IssueCode::notOneOf, "/operation", plunge, {{"/operation", "Plunge"}});
        row("1e309", IssueCode::outOfRange, "/part/stock_mm",
            R"({"format": "sparkout-project", "version": 1, "part": {"stock_mm": -1e309}})");
    }

    static void partRows() {
        const char* traverse = "smallest-traverse";
        const char* plunge = "smallest-plunge";
        const char* bore = "internal-plunge";
        const Severity warning = Severity::warning;
        row("out of range", IssueCode::outOfRange, "/wheel/dullness", plunge,
            {{"/wheel/dullness", 2}});
        row("unusual", IssueCode::unusual, "/wheel/dullness", plunge, {{"/wheel/dullness", 0.5}},
            warning);
        row("unusual whole number", IssueCode::unusual, "/part/lobes", plunge,
            {{"/part/profile", "lobes"}, {"/part/lobes", 90}}, warning);
        row("odd radii", IssueCode::notEven, "/part/radii_per_section", plunge,
            {{"/part/radii_per_section", 37}});
        row("few radii", IssueCode::fewRadii, "/part/radii_per_section", plunge,
            {{"/part/radii_per_section", 10}}, warning);
        row("profile length", IssueCode::wrongCount, "/part/radii_um", plunge,
            {{"/part/profile", "measured"}, {"/part/radii_um", std::vector<int>(35, -1)}});
        row("profile missing", IssueCode::missingKey, "/part/radii_um", plunge,
            {{"/part/profile", "measured"}});
        row("deviations reversed", IssueCode::deviationsReversed, "/part/lower_deviation_um",
            plunge, {{"/part/lower_deviation_um", 0}});
        row("machine range reversed", IssueCode::outOfRange, "/machine/limits/work_speed_rpm/1",
            traverse, {{"/machine/limits/work_speed_rpm", {300, 50, 1}}});
        row("no part left", IssueCode::outOfRange, "/part/lower_deviation_um", plunge,
            {{"/part/diameter_mm", 2}, {"/part/lower_deviation_um", -4000}});
        row("runout larger than the part", IssueCode::outOfRange, "/part/initial_runout_mm", plunge,
            {{"/part/diameter_mm", 2}, {"/part/initial_runout_mm", 1}});
        row("measured runout larger than the part", IssueCode::outOfRange, "/part/radii_um", bore,
            {{"/part/diameter_mm", 30},
             {"/wheel/diameter_mm", 20},
             {"/part/profile", "measured"},
             {"/part/radii_per_section", 4},
             {"/part/radii_um", {-9000, 0, 0, 0}}});
        row("target outside the field", IssueCode::targetOutsideField, "/part/target_diameter_mm",
            plunge, {{"/part/target_diameter_mm", 31}}, warning);
        row("no zone", IssueCode::zoneTooShort, "/part/length_mm", traverse,
            {{"/part/length_mm", 76}});
        row("overrun of the wheel width", IssueCode::outOfRange, "/machine/overrun_entry_mm",
            traverse, {{"/machine/overrun_entry_mm", 50}});
        row("overrun beyond the wheel width", IssueCode::outOfRange, "/machine/overrun_exit_mm",
            traverse, {{"/machine/overrun_exit_mm", 60}});
        row("wheel too narrow", IssueCode::wheelTooNarrow, "/wheel/width_mm", plunge,
            {{"/wheel/width_mm", 39.999}});
        row("wheel fills the bore", IssueCode::wheelTooLarge, "/wheel/diameter_mm", bore,
            {{"/wheel/diameter_mm", 60}});
        row("internal traverse", IssueCode::internalTraverse, "/part/surface", traverse,
            {{"/part/surface", "internal"}});
        row("shaft too short", IssueCode::shaftTooShort, "/part/shaft/segments",
            "stiffness-traverse", {{"/part/shaft/ground_from_mm", 61}});
        row("rest beside the shaft", IssueCode::outOfRange,
            "/part/shaft/steady_rests/0/position_mm", "stiffness-traverse",
            {{"/part/shaft/steady_rests/0/position_mm", 153}});
        row("no shaft", IssueCode::complianceMissing, "/part/shaft/segments", "stiffness-traverse",
            {{"/part/shaft/segments", json::array()}});
        row("no quill", IssueCode::complianceMissing, "/part/shaft/quill", bore,
            {{"/part/shaft/quill", nullptr}});
        row("no compliance", IssueCode::complianceMissing, "/machine/compliance_mm_per_n", traverse,
            {{"/machine/compliance_mm_per_n", nullptr}});
        row("list in traverse", IssueCode::wrongType, "/machine/compliance_mm_per_n", traverse,
            {{"/machine/compliance_mm_per_n", {1e-4, 1e-4, 1e-4}}});
        row("zones in plunge", IssueCode::wrongType, "/machine/compliance_mm_per_n", plunge,
            {{"/machine/compliance_mm_per_n", {{"rz1", 1e-4}, {"nz", 1e-4}, {"rz2", 1e-4}}}});
        row("zone missing", IssueCode::missingKey, "/machine/compliance_mm_per_n/nz", traverse,
            {{"/machine/compliance_mm_per_n", {{"rz1", 1e-4}, {"rz2", 1e-4}}}});
        row("sections without compliance", IssueCode::wrongCount, "/machine/compliance_mm_per_n",
            plunge, {{"/sections", 5}});
    }

    static void cycleRows() {
        const char* traverse = "smallest-traverse";
        const char* plunge = "smallest-plunge";
        const Severity warning = Severity::warning;
        const std::string stage = "/cycle/stages/0";
        row("no stages", IssueCode::wrongCount, "/cycle/stages", plunge,
            {{"/cycle/stages", json::array()}});
        row("1001 stages", IssueCode::wrongCount, "/cycle/stages", plunge,
            {{"/cycle/stages", std::vector<json>(1001, json::object())}});
        row("spark-out first", IssueCode::sparkOutNotLast, stage + "/spark_out", plunge,
            {{stage + "/spark_out", 5},
             {"/cycle/stages/1", {{"radial_feed_mm_min", 0.1}, {"stock_mm", 0.05}}}});
        row("feed of a spark-out", IssueCode::feedUnused, stage + "/radial_feed_mm_min", plunge,
            {{stage + "/spark_out", "until_size"}}, warning);
        row("no feed", IssueCode::feedMissing, stage + "/radial_feed_mm_min", plunge,
            {{stage + "/radial_feed_mm_min", 0}});
        row("no feed in traverse", IssueCode::feedMissing, stage + "/radial_feed_mm", traverse,
            {{stage + "/radial_feed_mm", 1e-7}});
        row("feed not given", IssueCode::missingKey, stage + "/radial_feed_mm_min", plunge,
            {{stage + "/radial_feed_mm_min", nullptr}});
        row("axial feed not given", IssueCode::missingKey, stage + "/axial_feed_mm_min", traverse,
            {{stage + "/axial_feed_mm_min", nullptr}});
        row("stocks do not sum up", IssueCode::stocksDoNotSumUp, "/cycle/stages", plunge,
            {{stage + "/stock_mm", 0.1}}, warning);
        row("more stages than commands", IssueCode::tooManyStages, "/cycle/stages", plunge,
            {{"/gauge/commands", 1},
             {"/cycle/stages/1", {{"radial_feed_mm_min", 0.1}, {"stock_mm", 0.05}}}},
            warning);
        row("gauge section", IssueCode::outOfRange, "/gauge/section", plunge,
            {{"/gauge/section", 4}});
        row("gauge position", IssueCode::outOfRange, "/gauge/position_mm", plunge,
            {{"/gauge/position_mm", 40.5}});
        row("gauge section in traverse", IssueCode::notUsedHere, "/gauge/section", traverse,
            {{"/gauge/section", 0}}, warning);
        row("coupled sections of given compliance", IssueCode::influenceUnknown,
            "/sections_coupled", plunge, {{"/sections_coupled", true}});
        const std::string rows = "/machine/wheel_contact/n_um_at_n";
        row("no contact rows", IssueCode::wrongCount, rows, plunge, {{rows, json::array()}});
        row("contact forces that fall", IssueCode::outOfRange, rows + "/1/0", plunge,
            {{rows, {{10, 5}, {10, 20}}}});
        row("contact without stiffness", IssueCode::outOfRange, rows + "/0/1", plunge,
            {{rows, json::array({json{10, 0}})}});
        row("numbers of a pair", IssueCode::wrongCount, "/batch/factors/dullness/uniform", plunge,
            {{"/batch", {{"factors", {{"dullness", {{"uniform", {0.1, 0.2, 0.3}}}}}}}}});
        row("one and a half stages", IssueCode::wrongType, "/optimisation/stages/0", plunge,
            {{"/optimisation", {{"stages", {1.5}}}}});
        row("half a spark-out", IssueCode::wrongType, "/optimisation/spark_out/1", plunge,
            {{"/optimisation", {{"spark_out", {0, 0.5}}}}});
        row("spark-outs by halves", IssueCode::wrongType, "/optimisation/spark_out/step", plunge,
            {{"/optimisation", {{"spark_out", {{"from", 0}, {"to", 2}, {"step", 0.5}}}}}});
        row("a stage without its most", IssueCode::wrongCount, "/optimisation/stage_stock_mm/0",
            plunge, {{"/optimisation", {{"stage_stock_mm", json::array({json{0.1}})}}}});
        const json dull = {{"input", "/wheel/dullness"}, {"from", 0.01}, {"to", 0.02}};
        json gone = dull;
        gone["input"] = "/cycle/stages/7/stock_mm";
        const auto sweep = [](std::vector<json> inputs) { return json{{"inputs", inputs}}; };
        row("a sweep over a stage that is not there", IssueCode::noSuchNumber,
            "/sweep/inputs/0/input", plunge, {{"/sweep", sweep({gone})}}, warning);
        row("a sweep over one input twice", IssueCode::variedTwice, "/sweep/inputs/1/input", plunge,
            {{"/sweep", sweep({dull, dull})}}, warning);
        row("a sweep over nothing", IssueCode::wrongCount, "/sweep/inputs", plunge,
            {{"/sweep", sweep({})}});
    }

    std::set<IssueCode> m_produced;
};

} // namespace test_project_file

SPARKOUT_TEST(test_project_file, TestProjectFile)
#include "test_project_file.moc"
