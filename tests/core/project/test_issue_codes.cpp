// SPDX-License-Identifier: GPL-3.0-or-later
// Each code of a fault is produced by a file, and has its sentence.
#include "tests/core/project/project_places.h"
#include "tests/registry.h"

namespace sparkout::test_issue_codes {

using namespace project_places;

class TestIssueCodes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(1000); }

    // --- every code -----------------------------------------------------------------------------

    void everyCode_data() {
        addColumns<QByteArray, int, bool, QString>("text", "code", "warning", "path");
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
                const std::string sentence = issueSentence(issue);
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
            QVERIFY2(*wordsOf(static_cast<IssueCode>(i)).sentence, std::to_string(i).c_str());
            QVERIFY2(m_produced.count(static_cast<IssueCode>(i)), std::to_string(i).c_str());
        }
    }

    void everyCodeHasAKeyOfItsOwn() {
        std::set<std::string> keys;
        for (int i = 0; i <= static_cast<int>(IssueCode::notAFileName); ++i) {
            keys.insert(wordsOf(static_cast<IssueCode>(i)).key);
        }
        QCOMPARE(keys.size(), static_cast<std::size_t>(IssueCode::notAFileName) + 1);
        QVERIFY(!keys.contains(""));
    }

    void everyPhraseHasItsWords() {
        std::set<std::string> words;
        for (int i = 0; i <= static_cast<int>(Phrase::nameOfLessonFile); ++i) {
            words.insert(wordsOf(static_cast<Phrase>(i)));
        }
        QCOMPARE(words.size(), static_cast<std::size_t>(Phrase::nameOfLessonFile) + 1);
        QVERIFY(!words.contains(""));
    }

    void detailsAreWrittenWithUnitAndOrigin_data() {
        addColumns<QString, QString>("written", "expected");
        const auto row = [](const char* name, const Detail& detail, const char* expected) {
            addRow(name, QString::fromStdString(Wording().detail(detail)), expected);
        };
        row("nothing", {}, "");
        row("number", Amount{1e-5}, "0.00001");
        row("amount", Amount{-2.5, "mm"}, "-2.5 mm");
        row("amount of a formula", Amount{0.5, "mm", "ΔR"}, "0.5 mm (ΔR)");
        row("count", Count{100'000}, "100000");
        row("bytes", Count{7, "bytes"}, "7 bytes");
        row("count of an input", Count{4, {}, "/sections"}, "4 (/sections)");
        row("range", Bounds{{0, 5, true}, "mm"}, "> 0…5 mm");
        row("least of an input", Bounds{{40}, "mm", "/part/length_mm"},
            "≥ 40 mm (/part/length_mm)");
        row("less than", Bounds{{.high = 50}, "mm", {}, "2R_t", true}, "< 50 mm (2R_t)");
        row("with a rounding error", Bounds{{.high = 5.8660000000000005}, "mm", {}, "2R_t", true},
            "< 5.866 mm (2R_t)");
        row("no range", Bounds{{}, "mm"}, "");
        row("members", Keys{{"rz1", "nz"}}, "rz1, nz");
        row("choices", Keys{{"min", "max"}, Keys::Kind::choices}, "\"min\", \"max\"");
        row("alternatives", Keys{{"grows", "normal"}, Keys::Kind::alternatives}, "grows | normal");
        row("phrase", Phrase::wholeNumber, "whole number");
        row("numeral", Numeral{"18446744073709551615"}, "18446744073709551615");
        row("quoted", Quoted{"\"a -5\""}, "\"a -5\"");
    }
    void detailsAreWrittenWithUnitAndOrigin() {
        QFETCH(QString, written);
        QFETCH(QString, expected);
        QCOMPARE(written, expected);
    }

    /// Lengths from B to 2·B − o_1 − o_2 with B = 50 mm; wheels of bores for bores alone.
    void aRefusedWidthNamesTheWheelsThatWouldDo_data() {
        addColumns<QByteArray, QString, QString>("text", "traverse", "plunge");
        const auto row = [](const char* name, const char* sampleName, const Changes& changes,
                            const char* traverse, const char* plunge) {
            addRow(name, QByteArray::fromStdString(changed(sampleName, changes).dump()),
                   QString(traverse), QString(plunge));
        };
        const char* file = "smallest-traverse"; // overruns of 12 mm
        const char* length = "/part/length_mm";
        row("50 mm", file, {{length, 50}}, "25", "50, 63, 80");
        row("57 mm", file, {{length, 57}}, "40, 25", "63, 80");
        row("76 mm", file, {{length, 76}}, "40, 25", "80");
        row("20 mm", file, {{length, 20}}, "", "25, 40, 50, 63, 80");
        row("plunge", "smallest-plunge", {{length, 60}}, "40, 25", "63, 80");
        Changes shoulder{{length, 76}, {"/machine/overrun_exit_mm", 0}};
        row("beside a shoulder", file, shoulder, "40, 25", "80");
        shoulder.push_back({"/machine/overrun_entry_mm", 0});
        row("between shoulders", file, shoulder, "25", "80");
        shoulder.front().second = 100;
        row("100 mm between shoulders", file, shoulder, "40, 25", "");
        const auto bore = [&](double diameter_mm, double wheel_mm) {
            return Changes{{length, 38},
                           {"/part/surface", "internal"},
                           {"/part/diameter_mm", diameter_mm},
                           {"/wheel/diameter_mm", wheel_mm}};
        };
        row("bore", file, bore(60, 40), "25", "40");
        row("narrow bore", file, bore(30, 20), "25", "");
        row("too narrow a bore", file, bore(20, 15), "", "");
    }
    void aRefusedWidthNamesTheWheelsThatWouldDo() {
        QFETCH(QByteArray, text);
        QFETCH(QString, traverse);
        QFETCH(QString, plunge);
        const Issues issues = readProject(text.toStdString()).issues;
        const auto found = std::ranges::find_if(
            issues, [](const Issue& issue) { return issue.wheel.has_value(); });
        QVERIFY2(found != issues.end(), samples::listed(issues).c_str());
        QStringList fitting;
        if (!traverse.isEmpty()) {
            fitting
                << QStringLiteral("to traverse %1 mm (overruns of a third at most)").arg(traverse);
        }
        if (!plunge.isEmpty()) {
            fitting << QStringLiteral("to plunge %1 mm").arg(plunge);
        }
        const QString expected =
            fitting.isEmpty() ? QStringLiteral(" (no wheel of the catalogue fits)")
                              : QStringLiteral(" (widths of the catalogue's wheels that fit: "
                                               "%1)")
                                    .arg(fitting.join(QStringLiteral("; ")));
        const QString sentence = QString::fromStdString(issueSentence(*found));
        QVERIFY2(sentence.endsWith(expected), qPrintable(sentence));
    }

    void aValueMayHoldThePlacesOfATemplate() {
        const Issue issue{IssueCode::outOfRange, Severity::error, "", Quoted{"{limit}"},
                          Quoted{"{value}"}};
        QCOMPARE(issueSentence(issue), std::string("{limit} is out of range; allowed: {value}"));
    }

private:
    using Changes = std::vector<std::pair<std::string, json>>;

    static void row(const char* name, IssueCode code, const std::string& path,
                    const std::string& text, Severity severity = Severity::error) {
        addRow(name, QByteArray::fromStdString(text), static_cast<int>(code),
               (severity == Severity::warning), QString::fromStdString(path));
    }

    /// A changed sample; a null value stands as null.
    static json changed(const char* sampleName, const Changes& changes) {
        json file = samples::sample(sampleName);
        for (const auto& [pointer, value] : changes) {
            file[json::json_pointer(pointer)] = value;
        }
        return file;
    }

    static void row(const char* name, IssueCode code, const std::string& path,
                    const char* sampleName, const Changes& changes,
                    Severity severity = Severity::error) {
        row(name, code, path, changed(sampleName, changes).dump(), severity);
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
        row("several surfaces", IssueCode::severalSurfaces, "/version", plunge, {{"/version", 2}});
        row("newer version", IssueCode::newerVersion, "/version", plunge, {{"/version", 3}});
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
        row("unusual beside others", IssueCode::unusualTogether, "/wheel/force_recipe/wear_flat_mm",
            plunge,
            {{"/wheel/force_recipe",
              {{"contact_factor", 3}, {"cut_width_mm", 0.24}, {"wear_flat_mm", 0.19}}}},
            warning);
        row("unusual whole number", IssueCode::unusual, "/part/lobes", plunge,
            {{"/part/profile", "lobes"}, {"/part/lobes", 90}}, warning);
        row("odd radii", IssueCode::notEven, "/part/radii_per_section", plunge,
            {{"/part/radii_per_section", 37}});
        row("few radii", IssueCode::fewRadii, "/part/radii_per_section", plunge,
            {{"/part/radii_per_section", 10}}, warning);
        row("lobes unknown", IssueCode::lobesUnknown, "/machine/form/lobes", traverse,
            {{"/machine/form", {{"roundness_um", {1, 2, 1}}}}}, warning);
        row("too few radii for the wheel's waves", IssueCode::wavesUnresolved,
            "/part/radii_per_section", plunge, {{"/wheel/runout", {{"amplitude_um", 1}}}});
        row("no form of the wheel's runout", IssueCode::wrongCount, "/wheel/runout", plunge,
            {{"/wheel/runout", {{"lobes", 2}}}});
        row("two forms of the wheel's runout", IssueCode::wrongCount, "/wheel/runout", plunge,
            {{"/wheel/runout", {{"amplitude_um", 1}, {"unbalance_g_mm", 5}}}});
        row("balance grade without a mass", IssueCode::missingKey, "/wheel/runout/rotor_mass_kg",
            plunge,
            {{"/wheel/runout", {{"balance_grade_mm_s", 1}}},
             {"/machine/stiffness_n_um",
              {{"headstock", 60}, {"tailstock", 40}, {"wheel_head", 50}}}});
        row("unbalance without a stiffness", IssueCode::missingKey, "/machine/stiffness_n_um",
            plunge, {{"/wheel/runout", {{"unbalance_g_mm", 5}}}});
        row("too few radii for the lobes", IssueCode::outOfRange, "/part/radii_per_section",
            traverse, {{"/machine/form", {{"roundness_um", {1, 2, 1}}, {"lobes", 4}}}});
        row("runout below roundness", IssueCode::outOfRange, "/machine/form/runout_um/1", traverse,
            {{"/machine/form",
              {{"roundness_um", {1, 2, 1}}, {"runout_um", {1, 1.5, 1}}, {"lobes", 2}}}});
        row("form of two zones", IssueCode::wrongCount, "/machine/form/runout_um", traverse,
            {{"/machine/form", {{"runout_um", {1, 2}}}}});
        row("profile length", IssueCode::wrongCount, "/part/radii_um", plunge,
            {{"/part/profile", "measured"}, {"/part/radii_um", std::vector<int>(35, -1)}});
        row("profile missing", IssueCode::missingKey, "/part/radii_um", plunge,
            {{"/part/profile", "measured"}});
        row("deviations reversed", IssueCode::deviationsReversed, "/part/lower_deviation_um",
            plunge, {{"/part/lower_deviation_um", 0}});
        row("machine range reversed", IssueCode::outOfRange, "/machine/limits/work_speed_rpm/1",
            traverse, {{"/machine/limits/work_speed_rpm", {300, 50, 1}}});
        row("part wider than the machine takes", IssueCode::machineMisfit, "/part/diameter_mm",
            traverse, {{"/machine/limits/part_diameter_mm", 29}}, warning);
        row("part longer than the machine takes", IssueCode::machineMisfit, "/part/length_mm",
            traverse, {{"/machine/limits/part_length_mm", 90}}, warning);
        row("shaft longer than the machine takes", IssueCode::machineMisfit, "/part/shaft/segments",
            traverse,
            {{"/machine/limits/part_length_mm", 249},
             {"/part/shaft/segments", {{{"length_mm", 250}, {"diameter_mm", 30}}}}},
            warning);
        row("wheel larger than the machine takes", IssueCode::machineMisfit, "/wheel/diameter_mm",
            traverse, {{"/machine/limits/wheel_diameter_mm", 499}}, warning);
        row("wheel narrower than the flanges hold", IssueCode::machineMisfit, "/wheel/width_mm",
            traverse, {{"/machine/limits/wheel_width_mm", {63, 100}}}, warning);
        row("wheel of another bore", IssueCode::machineMisfit, "/wheel/marking", traverse,
            {{"/wheel/marking", "500×50×203 25А F60 L 6 V"},
             {"/machine/limits/wheel_bore_mm", 305}},
            warning);
        row("wheel widths reversed", IssueCode::outOfRange, "/machine/limits/wheel_width_mm/1",
            traverse, {{"/machine/limits/wheel_width_mm", {100, 63}}});
        row("faster than the wheel may run", IssueCode::outOfRange, "/machine/wheel_speed_m_s",
            plunge, {{"/wheel/max_speed_m_s", 29.9}});
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
        row("no diameter left", IssueCode::tooMuchGap, "/part/gaps", traverse,
            {{"/part/gaps", {{{"from_deg", 0}, {"width_deg", 200}}}}});
        row("three radii left", IssueCode::tooMuchGap, "/part/gaps", traverse,
            {{"/part/radii_per_section", 12},
             {"/part/gaps",
              {{{"from_deg", 50}, {"width_deg", 120}}, {{"from_deg", 200}, {"width_deg", 160}}}}});
        row("gap between two radii", IssueCode::gapBetweenRadii, "/part/gaps/0/width_deg", traverse,
            {{"/part/gaps", {{{"from_deg", 1}, {"width_deg", 5}}}}}, warning);
        row("gauge in the gaps", IssueCode::gaugeDropsIn, "/gauge/spans_gaps", traverse,
            {{"/part/gaps", {{{"from_deg", 1}, {"width_deg", 20}}}}, {"/gauge/spans_gaps", false}});
        row("overrun of a blind bore's wall", IssueCode::wallOverrun, "/machine/overrun_entry_mm",
            traverse,
            {{"/part/surface", "internal"},
             {"/part/blind_bore", true},
             {"/wheel/diameter_mm", 20}});
        row("wheel that turns before the wall", IssueCode::stripAtWall, "/machine/overrun_entry_mm",
            traverse,
            {{"/part/surface", "internal"},
             {"/part/blind_bore", true},
             {"/wheel/diameter_mm", 20},
             {"/part/length_mm", 150},
             {"/machine/overrun_entry_mm", -2}},
            warning);
        row("no wall to turn before", IssueCode::outOfRange, "/machine/overrun_exit_mm", traverse,
            {{"/part/length_mm", 150}, {"/machine/overrun_exit_mm", -2}});
        row("overrun into a shoulder", IssueCode::shoulderInTheWay, "/machine/overrun_entry_mm",
            "stiffness-traverse", {{"/part/shaft/segments/0/diameter_mm", 40}}, warning);
        row("wheel between shoulders", IssueCode::shouldersTooNear, "/wheel/width_mm", plunge,
            {{"/machine/compliance_mm_per_n", nullptr},
             {"/machine/stiffness_n_um",
              {{"headstock", 60}, {"tailstock", 40}, {"wheel_head", 50}}},
             {"/part/shaft",
              {{"segments",
                {{{"length_mm", 30}, {"diameter_mm", 40}},
                 {{"length_mm", 40}, {"diameter_mm", 30}},
                 {{"length_mm", 30}, {"diameter_mm", 40}}}},
               {"ground_from_mm", 30}}}},
            warning);
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
        row("101 stages", IssueCode::wrongCount, "/cycle/stages", plunge,
            {{"/cycle/stages",
              std::vector<json>(101, json{{"radial_feed_mm_min", 1}, {"stock_mm", 0.001}})}});
        row("too many numbers", IssueCode::wrongCount, "/batch/factors/stock_mm/measured", plunge,
            {{"/batch/factors/stock_mm",
              {{"measured", std::vector<double>(limits::listNumbers + 1, 0.1)}}}});
        row("101 steps of the shaft", IssueCode::wrongCount, "/part/shaft/segments", plunge,
            {{"/part/shaft/segments",
              std::vector<json>(101, json{{"length_mm", 1}, {"diameter_mm", 30}})}});
        row("21 steady rests", IssueCode::wrongCount, "/part/shaft/steady_rests", plunge,
            {{"/part/shaft/steady_rests",
              std::vector<json>(21, json{{"position_mm", 1}, {"stiffness_n_um", 30}})}});
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
        row("burn beside a threshold", IssueCode::notWithThreshold, "/material/burn_rise_k", plunge,
            {{"/material/force_law", "threshold"}, {"/material/burn_rise_k", 700}});
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

} // namespace sparkout::test_issue_codes

SPARKOUT_TEST(test_issue_codes, TestIssueCodes)
#include "test_issue_codes.moc"
