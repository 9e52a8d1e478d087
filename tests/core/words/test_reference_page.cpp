// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
#include "core/batch/batch_outputs.h"
#include "core/batch/batch_run.h"
#include "core/file/project_file.h"
#include "core/lesson/work.h"
#include "core/phases/phase_decision.h"
#include "core/project/batch.h"
#include "core/project/machine.h"
#include "core/quality/constraints.h"
#include "core/quality/result_json.h"
#include "core/simulation/simulate.h"
#include "core/study/remedies.h"
#include "core/study/search.h"
#include "core/study/search_outputs.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "words/json_schema.h"
#include "words/judgement_words.h"
#include "words/lesson_page.h"
#include "words/measured_words.h"
#include "words/reference_page.h"
#include "words/result_schema.h"

#include <QRegularExpression>
#include <QTest>

#include <tuple>
#include <vector>

namespace sparkout::test_reference_page {

using nlohmann::json;

/// As much of JSON Schema as projectSchema() uses. The fault found, or nothing.
class SchemaCheck {
public:
    static std::string fault(const json& root, const json& value) {
        const bool then = fault(root.at("if"), value, "").empty();
        const std::string ref = root.at(then ? "then" : "else").at("$ref");
        return fault(root.at(json::json_pointer(ref.substr(1))), value, "");
    }
    static std::string faultOf(const json& schema, const json& value) {
        return fault(schema, value, "");
    }

private:
    static std::string fault(const json& schema, const json& value, const std::string& path) {
        if (const auto list = schema.find("anyOf"); list != schema.end()) {
            const bool one = std::any_of(list->begin(), list->end(), [&](const json& item) {
                return fault(item, value, path).empty();
            });
            return one ? "" : path + ": none of anyOf";
        }
        if (schema.contains("const") && value != schema.at("const")) {
            return path + ": not the const";
        }
        if (schema.contains("enum")) {
            const json& all = schema.at("enum");
            if (std::find(all.begin(), all.end(), value) == all.end()) {
                return path + ": not in the enum";
            }
        }
        if (schema.contains("type") && !hasType(schema.at("type"), value)) {
            return path + ": type";
        }
        std::string found = value.is_number()  ? numberFault(schema, value.get<double>(), path)
                            : value.is_array() ? arrayFault(schema, value, path)
                                               : "";
        return found.empty() && value.is_object() ? objectFault(schema, value, path) : found;
    }

    static bool hasType(const json& type, const json& value) {
        if (type.is_array()) {
            return std::any_of(type.begin(), type.end(),
                               [&](const json& one) { return hasType(one, value); });
        }
        const std::string name = type;
        return (name == "null" && value.is_null()) || (name == "boolean" && value.is_boolean())
               || (name == "string" && value.is_string()) || (name == "array" && value.is_array())
               || (name == "object" && value.is_object()) || (name == "number" && value.is_number())
               || (name == "integer" && value.is_number()
                   && value.get<double>() == std::floor(value.get<double>()));
    }

    static std::string numberFault(const json& schema, double value, const std::string& path) {
        const bool low = schema.contains("minimum") && value < schema.at("minimum").get<double>();
        const bool open = schema.contains("exclusiveMinimum")
                          && value <= schema.at("exclusiveMinimum").get<double>();
        const bool high = schema.contains("maximum") && value > schema.at("maximum").get<double>();
        return low || open || high ? path + ": range" : "";
    }

    static std::string arrayFault(const json& schema, const json& value, const std::string& path) {
        if (value.size() < schema.value("minItems", std::size_t{0})
            || value.size() > schema.value("maxItems", std::size_t{1} << 60)) {
            return path + ": count";
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            std::string found = fault(schema.at("items"), value[i], path + "/" + std::to_string(i));
            if (!found.empty()) {
                return found;
            }
        }
        return {};
    }

    static std::string objectFault(const json& schema, const json& value, const std::string& path) {
        if (!schema.contains("properties")) {
            return {};
        }
        for (const json& key : schema.value("required", json::array())) {
            if (!value.contains(key)) {
                return path + ": misses " + key.get<std::string>();
            }
        }
        const json& properties = schema.at("properties");
        for (const auto& [key, item] : value.items()) {
            if (!properties.contains(key)) {
                if (schema.contains("additionalProperties")) {
                    return path + ": knows no " + key;
                }
                continue;
            }
            std::string found = fault(properties.at(key), item, path + "/" + key);
            if (!found.empty()) {
                return found;
            }
        }
        return {};
    }
};

Project example(const std::string& name) {
    const auto path = samples::sourcePath("resources/examples/" + name + ".sparkout");
    return readProject(samples::readText(path)).project.value();
}

const char* refresh = "not up to date: cmake --build build/release --target sparkout-reference && "
                      "build/release/app/sparkout-reference resources/help python/sparkout.pyi";

class TestReferencePage : public QObject {
    Q_OBJECT

private slots:
    void shippedFilesAreUpToDate() {
        using samples::readText;
        using samples::sourcePath;
        QVERIFY2(readText(sourcePath("resources/help/en/project-file.md")) == referencePage(),
                 refresh);
        QVERIFY2(readText(sourcePath("resources/help/en/lesson-file.md")) == lessonPage(), refresh);
        QVERIFY2(readText(sourcePath("resources/help/project.schema.json")) == projectSchema(),
                 refresh);
        QVERIFY2(readText(sourcePath("resources/help/lesson.schema.json")) == lessonSchema(),
                 refresh);
        QVERIFY2(readText(sourcePath("resources/help/results.schema.json")) == resultSchema(),
                 refresh);
        QVERIFY2(readText(sourcePath("python/sparkout.pyi"))
                     == resultStubs(readText(sourcePath("python/sparkout.pyi.in"))),
                 refresh);
    }

    /// Each table of the schema of results takes what the command line states by it.
    void theSchemaOfResultsTakesWhatIsStated() {
        const json schema = json::parse(resultSchema());
        const auto faultOf = [&schema](const char* table, const json& stated) {
            return SchemaCheck::faultOf(schema.at("$defs").at(table), stated);
        };
        for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            const Project project = example(name);
            const SimulationResult result = simulate(project);
            const json simulated = json::parse(resultJson(result, evaluateConstraints(result)));
            const json& shop = simulated.at("shop");
            QCOMPARE(faultOf("shop", shop), std::string());
            QCOMPARE(faultOf("stage", shop.at("cycle")), std::string());
            for (const json& stage : shop.at("stages")) {
                QCOMPARE(faultOf("stage", stage), std::string());
            }
            const json judged =
                json::parse(judgedResultJson(result, {}, judge(result, {}, judgeStocks(result))))
                    .at("judged");
            QCOMPARE(faultOf("judged", judged), std::string());
            QCOMPARE(faultOf("judged_stocks", judged.at("stocks")), std::string());
            for (const json& undecided : judged.at("not_decided")) {
                QCOMPARE(faultOf("undecided", undecided), std::string());
            }
            const bool travels = project.operation->travels;
            for (const json& zone : simulated.at(travels ? "zones" : "sections")) {
                QCOMPARE(faultOf("zone", zone), std::string());
                QCOMPARE(faultOf("position", zone), std::string());
            }
            QCOMPARE(faultOf("part_form", simulated.at("part")), std::string());
            QCOMPARE(faultOf("burn", simulated.at("burn")), std::string());
            for (const json& requirement : simulated.at("constraints")) {
                QCOMPARE(faultOf("requirement", requirement), std::string());
            }
            const bool isQuick = project.operation->axial() != nullptr;
            const json found = json::parse(searchJson(*search(project, {.phases = isQuick})));
            QCOMPARE(faultOf("search", found), std::string());
            json wrong = found;
            wrong["grid_size"] = "large";
            QCOMPARE(faultOf("search", wrong), std::string("/grid_size: type"));
            wrong.erase("grid_size");
            QVERIFY(!faultOf("search", wrong).empty());
        }
        Project divided = example("shaft-30h6-factory");
        divided.zone_sections = 3;
        divided.machine->geometric_runout_um = 0;
        divided.machine->form = MachineForm{std::vector<double>(3, 1.0), {}, {}, {}}; // no lobes
        const json zones = json::parse(resultJson(simulate(divided), {})).at("zones");
        QCOMPARE(zones.size(), std::size_t{3});
        for (const json& zone : zones) {
            QCOMPARE(faultOf("even_lobes", zone), std::string());
            QCOMPARE(faultOf("zone_form", zone), std::string());
            QCOMPARE(zone.at("sections").size(), std::size_t{3});
            for (const json& section : zone.at("sections")) {
                QCOMPARE(faultOf("position", section), std::string());
                QCOMPARE(faultOf("zone_section", section), std::string());
            }
        }
        const SimulationResult dull = simulate(example("wheel-dull"));
        const json remedies =
            json::parse(remediesJson(dull.project, findRemedies(dull, evaluateConstraints(dull))));
        QCOMPARE(faultOf("remedies", remedies), std::string());
        QVERIFY(!remedies.at("remedies").empty());
        for (const json& remedy : remedies.at("remedies")) {
            QCOMPARE(faultOf("remedy", remedy), std::string());
        }
        Project batched = example("shaft-30h6-factory");
        batched.batch->parts = 20;
        const json batch = json::parse(batchJson(runBatch(batched), std::nullopt));
        for (const json& characteristic : batch.at("characteristics")) {
            QCOMPARE(faultOf("characteristic", characteristic), std::string());
        }
    }

    void theSchemaOfResultsTakesWhatWasMeasuredAndDecided() {
        const json schema = json::parse(resultSchema());
        const Project project = example("plunge-shaft-two-stage");
        MeasuredAnswer answer;
        MeasuredStatistics parts;
        parts.count = 3;
        parts.deviation = 1;
        parts.values = {-1, 0, 1};
        const PredictedRange range{.low = -2, .high = 2, .mean = 0, .deviation = 1, .count = 100};
        answer.rows = {judgeAdequacy(parts, range, {.bias = 1})};
        answer.fit.emplace().values.emplace_back();
        answer.fit->residuals.emplace_back();
        const json measured = json::parse(measuredJson(project, answer));
        const json decided = json::parse(phasesJson(decidePhases(project, usualPhases(project))));
        const std::vector<std::tuple<const char*, const json&, const char*>> stated{
            {"adequacy", measured, "/adequacy/0"},
            {"predicted", measured, "/adequacy/0/predicted"},
            {"variance_ratio", measured, "/adequacy/0/variance_ratio"},
            {"inside", measured, "/adequacy/0/inside"},
            {"identification", measured, "/identification"},
            {"fitted_value", measured, "/identification/values/0"},
            {"residuals", measured, "/identification/residuals/0"},
            {"phases", decided, ""},
            {"phase_piece", decided, "/pieces/0"},
            {"phase_worst", decided, "/pieces/0/worst"}};
        for (const auto& [table, whole, place] : stated) {
            const auto& object = whole.at(json::json_pointer(place));
            QVERIFY2(object.is_object(), place);
            QCOMPARE(SchemaCheck::faultOf(schema.at("$defs").at(table), object), std::string());
        }
    }

    void theSchemaTakesTheShippedLessonsAndRefusesTheirFaults() {
        const json schema = json::parse(lessonSchema());
        for (const auto& file : samples::lessonFiles()) {
            const json lesson = json::parse(samples::readText(file));
            const auto faultWith = [&](const char* pointer, const json& value) {
                json changed = lesson;
                changed[json::json_pointer(pointer)] = value;
                return SchemaCheck::fault(schema, changed);
            };
            QCOMPARE(SchemaCheck::fault(schema, lesson), std::string());
            QCOMPARE(faultWith("/guide/minutes", 0), std::string("/guide/minutes: range"));
            QCOMPARE(faultWith("/steps/0/colour", 1), std::string("/steps/0: knows no colour"));
            QCOMPARE(faultWith("/steps/0/others", "open"),
                     std::string("/steps/0/others: not in the enum"));
            QCOMPARE(faultWith("/title/en", nullptr), std::string("/title/en: type"));
            QCOMPARE(faultWith("/version", 2), std::string("/version: not the const"));
            const Work work = newWork(readLesson(samples::readText(file)).lesson.value(), {}, {}, 1,
                                      "A student", "ТМ-31");
            json handedIn = json::parse(writeWork(work));
            QCOMPARE(SchemaCheck::fault(schema, handedIn), std::string());
            handedIn["variant"] = 0;
            QCOMPARE(SchemaCheck::fault(schema, handedIn), std::string("/variant: range"));
        }
    }

    void pageNamesEveryKeyWithUnitAndHint() {
        const std::string page = referencePage();
        for (const samples::Place& place : samples::places()) {
            const std::size_t row = page.find("| `" + std::string(place.field->key) + "` |");
            QVERIFY2(row != std::string::npos, place.path.c_str());
            QVERIFY(page.find(place.field->hint) != std::string::npos);
            QVERIFY(page.find(place.field->nullMeaning) != std::string::npos);
        }
        std::istringstream lines(page);
        for (std::string line; std::getline(lines, line);) {
            QVERIFY2(line.empty() || line[0] != '|'
                         || std::count(line.begin(), line.end(), '|') == 9,
                     line.c_str());
        }
    }

    void conditionsAreWorded_data() {
        addColumns<QString, QString, QString>("path", "required", "relevant");
        QTest::newRow("always") << "/wheel/width_mm"
                                << "always"
                                << "";
        QTest::newRow("traverse") << "/machine/dwell_exit_s"
                                  << "traverse"
                                  << "traverse";
        QTest::newRow("measured") << "/part/radii_um"
                                  << "measured"
                                  << "measured";
        QTest::newRow("stage") << "/cycle/stages/*/radial_feed_mm_min"
                               << "plunge, the stage feeds"
                               << "plunge, the stage feeds";
        QTest::newRow("gauge") << "/gauge/section"
                               << ""
                               << "plunge, gauge at a section";
        QTest::newRow("centres") << "/machine/stiffness_n_um/tailstock"
                                 << "external, between centres"
                                 << "external, between centres";
    }
    void conditionsAreWorded() {
        QFETCH(QString, path);
        QFETCH(QString, required);
        QFETCH(QString, relevant);
        for (const samples::Place& place : samples::places()) {
            if (place.path == path.toStdString()) {
                const auto text = [&](Condition condition) {
                    return condition ? conditionText(condition, *place.table) : std::string();
                };
                QCOMPARE(text(place.field->required), required.toStdString());
                QCOMPARE(text(place.field->relevant), relevant.toStdString());
                return;
            }
        }
        QFAIL("no such key");
    }

    void validProjectsSatisfyTheSchema_data() {
        addColumns<QString, bool>("file", "vector");
        for (const char* folder : {"tests/data/projects", "resources/examples"}) {
            for (const auto& entry :
                 std::filesystem::directory_iterator(samples::sourcePath(folder))) {
                if (entry.path().extension() == ".sparkout") {
                    QTest::newRow(entry.path().filename().string().c_str())
                        << QString::fromStdString(entry.path().string()) << false;
                }
            }
        }
        for (const auto& entry :
             std::filesystem::directory_iterator(samples::sourcePath("tests/data/vectors"))) {
            if (entry.path().extension() == ".json") {
                QTest::newRow(entry.path().filename().string().c_str())
                    << QString::fromStdString(entry.path().string()) << true;
            }
        }
    }
    void validProjectsSatisfyTheSchema() {
        QFETCH(QString, file);
        QFETCH(bool, vector);
        json project = json::parse(samples::readText(file.toStdString()));
        if (vector) {
            project = project.at("project");
        }
        const ReadResult read = readProject(project.dump());
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const json schema = json::parse(projectSchema());
        const std::string fault = SchemaCheck::fault(schema, project);
        QVERIFY2(fault.empty(), fault.c_str());
        const json written = json::parse(writeProject(*read.project));
        QVERIFY2(SchemaCheck::fault(schema, written).empty(), "as written");
    }

    /// Each value of the fullest file replaced by wrong ones: where the schema refuses the reader
    /// does, and where the reader finds a wrong type, key or range in a value the schema does.
    void schemaAndReaderAgree() {
        const json schema = json::parse(projectSchema());
        const json whole = samples::sample("everything").flatten();
        int refused = 0, leaf = 0;
        const int step = samples::sized(1, 12, 1);
        for (const auto& [path, value] : whole.items()) {
            if (path.starts_with("/runs") || leaf++ % step != 0) {
                continue; // a kept run's inputs are an object to the schema
            }
            for (const json& wrong :
                 {json(nullptr), json(true), json(-1e30), json(1e30), json(0.5), json(""),
                  json("x"), json::array(), json{"x"}, json::object(), json{{"x", 1}}}) {
                json file = samples::sample("everything");
                file[json::json_pointer(path)] = wrong;
                const std::string fault = SchemaCheck::fault(schema, file);
                const Issues issues = samples::faults(file);
                if (!fault.empty()) {
                    ++refused;
                    QVERIFY2(hasErrors(issues), (path + " " + wrong.dump() + fault).c_str());
                }
                for (const Issue& issue : issues) {
                    if (issue.path.starts_with("/optimisation/spark_out/")) {
                        continue; // whole numbers among levels are a rule beyond the tables
                    }
                    const bool ofTheValue = issue.code == IssueCode::wrongType
                                            || issue.code == IssueCode::notOneOf
                                            || issue.code == IssueCode::unknownKey;
                    QVERIFY2(!ofTheValue || !fault.empty(),
                             (path + " " + wrong.dump() + "\n" + samples::listed(issues)).c_str());
                }
            }
        }
        QVERIFY(refused > 1000 / step);
    }

    /// What the surfaces share stands once, the rest in each of them, and neither elsewhere.
    void schemaAndReaderAgreeOnSetups() {
        const json schema = json::parse(projectSchema());
        json other = samples::sample("everything");
        other["part"]["shaft"]["ground_from_mm"] = 1;
        const json good = setup_samples::setupOf({samples::sample("everything"), other});
        const ReadSetup read = readSetup(good.dump());
        QVERIFY2(read.setup, samples::listed(read.issues).c_str());
        QCOMPARE(SchemaCheck::fault(schema, good), std::string());
        QCOMPARE(SchemaCheck::fault(schema, json::parse(writeSetup(*read.setup))), std::string());
        const auto bothRefuse = [&schema](const json& file, const std::string& fault) {
            QCOMPARE(SchemaCheck::fault(schema, file), fault);
            QVERIFY(hasErrors(readSetup(file.dump()).issues));
        };
        for (const char* shared : setup_samples::sharedPlaces) {
            const json::json_pointer place(shared);
            if (!good.contains(place)) {
                continue;
            }
            json file = good;
            file["surfaces"][1][place] = good.at(place);
            bothRefuse(file, "/surfaces/1" + place.parent_pointer().to_string() + ": knows no "
                                 + place.back());
        }
        for (const auto& [key, value] : good.at("surfaces")[0].items()) {
            if (good.contains(key) || key == "name") {
                continue;
            }
            json file = good;
            file[key] = value;
            bothRefuse(file, ": knows no " + key);
        }
        json file = good;
        file.erase("wheel");
        bothRefuse(file, ": misses wheel");
        file = good;
        file["surfaces"][1].erase("cycle");
        bothRefuse(file, "/surfaces/1: misses cycle");
        file = good;
        file["times"] = {{"handling_s", -1}};
        bothRefuse(file, "/times/handling_s: range");
        file = good;
        file["surfaces"] = json::array();
        bothRefuse(file, "/surfaces: count");
    }

    /// What the reader refuses and the schema passes is named in its description.
    void theSchemaNamesItsGaps() {
        const json schema = json::parse(projectSchema());
        const std::string text = schema.at("description");
        int conditional = 0;
        for (const char* name : {"smallest-traverse", "everything"}) {
            Project project = samples::project(name);
            for (const samples::Spot& spot : samples::spots(project)) {
                const json::json_pointer pointer(spot.path);
                json file = samples::sample(name);
                if (spot.path.starts_with("/runs") || !file.contains(pointer)) {
                    continue;
                }
                file[pointer.parent_pointer()].erase(pointer.back());
                const Issues issues = samples::faults(file);
                if (samples::holds(issues, IssueCode::missingKey, spot.path)
                    && SchemaCheck::fault(schema, file).empty()) {
                    const QString path = QString::fromStdString(spot.path).replace(
                        QRegularExpression(QStringLiteral("/\\d+/")), QStringLiteral("/N/"));
                    QVERIFY2(QString::fromStdString(text).contains(path), qPrintable(path));
                    ++conditional;
                }
            }
        }
        QVERIFY(conditional > 5);
        json file = samples::sample("smallest-traverse");
        const auto passes = [&] { return SchemaCheck::fault(schema, file).empty(); };
        file["part"]["lower_deviation_um"] = 900;
        QVERIFY(passes() && hasErrors(samples::faults(file)));
        QVERIFY(text.find("rules between values") != std::string::npos);
        file = samples::sample("everything");
        file["runs"][0]["inputs"] = json::object();
        QVERIFY(passes() && hasErrors(samples::faults(file)));
        QVERIFY(text.find("kept run") != std::string::npos);
        file = samples::sample("everything");
        file["optimisation"]["spark_out"] = {1.5};
        QVERIFY(passes() && hasErrors(samples::faults(file)));
        QVERIFY(text.find("not a whole number") != std::string::npos);
    }

    void schemaRefusesAMissingRequiredKeyAndAnUnknownOne() {
        const json schema = json::parse(projectSchema());
        const json good = samples::sample("smallest-plunge");
        for (const char* path :
             {"/format", "/version", "/operation", "/part/diameter_mm", "/material/flow_stress_mpa",
              "/wheel/dullness", "/machine/work_speed_rpm", "/cycle/stages"}) {
            json bad = good;
            const json::json_pointer pointer(path);
            bad[pointer.parent_pointer()].erase(pointer.back());
            QVERIFY2(!SchemaCheck::fault(schema, bad).empty(), path);
        }
        json bad = good;
        bad["wheel"]["colour"] = "white";
        QCOMPARE(SchemaCheck::fault(schema, bad), std::string("/wheel: knows no colour"));
    }
};

} // namespace sparkout::test_reference_page

SPARKOUT_TEST(test_reference_page, TestReferencePage)
#include "test_reference_page.moc"
