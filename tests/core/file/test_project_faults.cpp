// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a project file is named, all at once, with path, value and what is allowed.
#include "core/digits.h"
#include "core/project/range_check.h"
#include "tests/check_line.h"
#include "tests/core/project/project_places.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_project_faults {

using namespace project_places;

class TestProjectFaults : public QObject {
    Q_OBJECT

    int m_limits = 0;

private slots:
    void cleanupTestCase() {
        checkLine("16", m_limits, m_limits, m_limits > 100,
                  QStringLiteral("limits of inputs: at them taken, one step beyond and at ±1e300 "
                                 "refused with path, value and range"));
    }

    void initTestCase() { setRapidcheckRuns(1000); }

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
                QVERIFY2(!Wording().detail(samples::find(issues, spot.path)->limit).empty(),
                         spot.path.c_str());
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

    /// A sum of steps may miss the length by rounding, by no more.
    void aShaftMayBeShortByRoundingAlone() {
        Project project = samples::project("stiffness-traverse");
        const auto shortBy = [&](double missing_mm) {
            Project short_ = project;
            const double needed = short_.part->shaft.ground_from_mm + short_.part->length_mm;
            short_.part->shaft.steady_rests.clear();
            short_.part->shaft.segments.assign(10, {needed / 10, 30});
            short_.part->shaft.segments.back().length_mm -= missing_mm;
            return holds(validate(short_), IssueCode::shaftTooShort, "/part/shaft/segments");
        };
        project.part->shaft.ground_from_mm = 0.1;
        QVERIFY(!shortBy(0));
        QVERIFY(!shortBy(0.9e-9));
        QVERIFY(shortBy(1.1e-9));
        QVERIFY(shortBy(1e-3));
    }

    /// As the decimals of a file add up.
    void stocksMayMissTheirSumByRoundingAlone() {
        Project project = samples::project("smallest-plunge");
        const Stage stage = project.cycle->stages.front();
        project.part->stock_mm = 0.3;
        const auto warns = [&](double second_mm) {
            project.cycle->stages.assign(2, stage);
            project.cycle->stages[0].stock_mm = 0.1;
            project.cycle->stages[1].stock_mm = second_mm;
            return holds(validate(project), IssueCode::stocksDoNotSumUp, "/cycle/stages");
        };
        QVERIFY(0.1 + 0.2 != 0.3);
        QVERIFY(!warns(0.2));
        QVERIFY(!warns(0.2 + 0.9e-9));
        QVERIFY(warns(0.2 + 1.1e-9));
    }

    void aWheelAsWideAsThePartIsWideEnough() {
        Project project = samples::project("smallest-plunge");
        project.wheel->width_mm = project.part->length_mm;
        QVERIFY(!hasErrors(validate(project)));
        project.wheel->width_mm = std::nextafter(project.part->length_mm, 0);
        QVERIFY(holds(validate(project), IssueCode::wheelTooNarrow, "/wheel/width_mm"));
    }

    /// Stock and runout stand inside a bore on both sides.
    void aWheelMustFitTheBlanksBore() {
        Project project = fixtures::plunge();
        project.part->surface = Surface::internal;
        project.part->target_diameter_mm = project.part->diameter_mm;
        project.part->stock_mm = 0.2;
        project.part->initial_runout_mm = 0.1;
        const double bore = project.part->diameter_mm - 0.6;
        project.wheel->diameter_mm = bore - 1e-6;
        QVERIFY(!holds(validate(project), IssueCode::wheelTooLarge, "/wheel/diameter_mm"));
        project.wheel->diameter_mm = bore + 1e-6;
        QVERIFY(holds(validate(project), IssueCode::wheelTooLarge, "/wheel/diameter_mm"));
    }

    void limitsAreShownWithTheirSide() {
        const double infinity = std::numeric_limits<double>::infinity();
        QCOMPARE(rangeText({0, infinity, true}, "kW"), std::string("> 0 kW"));
        QCOMPARE(rangeText({0, infinity}, "mm"), std::string("≥ 0 mm"));
        QCOMPARE(rangeText({-infinity, 5}, "mm"), std::string("≤ 5 mm"));
        QCOMPARE(rangeText({0, 5, true}, "mm"), std::string("> 0…5 mm"));
        QCOMPARE(rangeText({0, 5}, ""), std::string("0…5"));
        QCOMPARE(rangeText({305, 305}, "mm"), std::string("305 mm"));
    }

    /// The limits themselves, apart from the table and the page that is made of it.
    void dwellsAndDrivesHaveTheirLimits_data() {
        addColumns<QString, double, bool>("key", "value", "allowed");
        for (const char* dwell : {"dwell_entry_s", "dwell_exit_s"}) {
            QTest::addRow("%s none", dwell) << QString(dwell) << 0.0 << true;
            QTest::addRow("%s an hour", dwell) << QString(dwell) << 3600.0 << true;
            QTest::addRow("%s more", dwell) << QString(dwell) << 3600.5 << false;
            QTest::addRow("%s negative", dwell) << QString(dwell) << -0.001 << false;
        }
        for (const char* drive : {"wheel_drive_kw", "work_drive_kw"}) {
            QTest::addRow("%s none", drive) << QString(drive) << 0.0 << false;
            QTest::addRow("%s little", drive) << QString(drive) << 1e-6 << true;
            QTest::addRow("%s a megawatt", drive) << QString(drive) << 1000.0 << true;
            QTest::addRow("%s more", drive) << QString(drive) << 1000.5 << false;
            QTest::addRow("%s negative", drive) << QString(drive) << -1.0 << false;
        }
    }
    void dwellsAndDrivesHaveTheirLimits() {
        QFETCH(QString, key);
        QFETCH(double, value);
        QFETCH(bool, allowed);
        json file = samples::sample("smallest-traverse");
        file["machine"][key.toStdString()] = value;
        const ReadResult read = readProject(file.dump());
        QCOMPARE(read.project.has_value(), allowed);
        QCOMPARE(holds(read.issues, IssueCode::outOfRange, "/machine/" + key.toStdString()),
                 !allowed);
    }

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
        const bool whole = place.field->kind == Kind::integer
                           || place.field->kind == Kind::countOrWord
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
                           && issue.limit == Detail(Bounds{hard, place.field->unit})
                           && Wording().detail(issue.value).starts_with(plainNumber(x));
                });
            };
            m_limits += 2;
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
            QCOMPARE(issue.value, Detail(Quoted{"\"colour\""}));
            QVERIFY2(!Wording().detail(issue.limit).empty(), path.c_str());
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
        QVERIFY(Wording().detail(issues[1].value).size() < 100);
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

    /// A value out of its range is one fault, and no rule goes on from it to refuse others or to
    /// allow what makes no sense (a diameter of −1: "allowed: 0…−0.25 mm").
    void aRefusedValueAccusesNoOther() {
        int refused = 0;
        for (const char* name : {"smallest-traverse", "smallest-plunge", "complete",
                                 "internal-plunge", "everything"}) {
            Project project = samples::project(name);
            for (const samples::Spot& spot : samples::spots(project)) {
                const bool number = spot.field->kind == Kind::number
                                    || spot.field->kind == Kind::optionalNumber
                                    || spot.field->kind == Kind::integer
                                    || spot.field->kind == Kind::optionalInteger;
                const json::json_pointer pointer(spot.path);
                if (!number || spot.path.starts_with("/runs")
                    || !samples::sample(name).contains(pointer)) {
                    continue;
                }
                for (const double wrong : {-1e9, 1e9}) {
                    json file = samples::sample(name);
                    file[pointer] = wrong;
                    const Issues issues = samples::faults(file);
                    if (!samples::find(issues, spot.path)
                        || samples::find(issues, spot.path)->severity != Severity::error) {
                        continue;
                    }
                    ++refused;
                    for (const Issue& issue : issues) {
                        QVERIFY2(issue.path == spot.path || issue.severity != Severity::error,
                                 (spot.path + '\n' + samples::listed(issues)).c_str());
                    }
                }
            }
        }
        QVERIFY2(refused > 200, QByteArray::number(refused));
    }

    void oneFaultIsNamedOnce() {
        json file = samples::sample("smallest-traverse");
        file["cycle"]["stages"][0]["radial_feed_mm"] = -1;
        file["part"]["radii_per_section"] = 3601;
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
};

} // namespace sparkout::test_project_faults

SPARKOUT_TEST(test_project_faults, TestProjectFaults)
#include "test_project_faults.moc"
