// SPDX-License-Identifier: GPL-3.0-or-later
// Runs held against each other: what they differ in is named by its place and nothing else is.
#include "core/study/run_comparison.h"

#include "core/batch/judgement.h"
#include "core/digits.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/outcome.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_run_comparison {

struct Ran {
    explicit Ran(const Project& of) : project(of) {
        const OutcomePtr outcome = evaluate(project);
        summary = {summarise(outcome->result, outcome->accuracy, outcome->constraints), {}};
        constraints = outcome->constraints;
    }
    [[nodiscard]] ComparedRun compared() const { return {&project, &summary}; }
    [[nodiscard]] RunPlaces places() const { return {project, summary.summary}; }

    Project project;
    ReadSummary summary;
    std::vector<ConstraintResult> constraints;
};

Project traverse() {
    return samples::project("smallest-traverse");
}

std::vector<std::string> pathsOf(const std::vector<ComparedRow>& rows) {
    std::vector<std::string> paths;
    for (const ComparedRow& row : rows) {
        paths.push_back(row.path);
    }
    return paths;
}

std::vector<std::string> pathsOf(const std::vector<RunValue>& values) {
    std::vector<std::string> paths;
    for (const RunValue& value : values) {
        paths.push_back(value.path);
    }
    return paths;
}

const RunValue* find(const std::vector<RunValue>& values, const std::string& path) {
    const auto found = std::ranges::find(values, path, &RunValue::path);
    return found == values.end() ? nullptr : &*found;
}

/// The number of a leaf in a summary of one's own, to change it.
double& numberAt(RunSummary& summary, const std::string& path) {
    for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &summary)) {
        if (leaf.path == path) {
            return leaf.field->as<double>(const_cast<void*>(leaf.owner));
        }
    }
    throw std::runtime_error(path);
}

class TestRunComparison : public QObject {
    Q_OBJECT

private slots:
    void aRunDiffersInNothingFromItself() {
        for (const char* name : {"smallest-traverse", "smallest-plunge"}) {
            const Ran ran(samples::project(name));
            QVERIFY(compareRuns({ran.compared(), ran.compared(), ran.compared()}).empty());
            QVERIFY(compareRuns({ran.compared()}).empty());
            QVERIFY(compareRuns({ran.compared(), ComparedRun{}}).empty()); // nothing known of it
        }
        QVERIFY(compareRuns({}).empty());
    }

    /// Every number that the model reads, one after the other, changed in its last bit.
    void oneInputIsOneRow() {
        const Project before = traverse();
        int changed = 0;
        for (const RunValue& input : inputsRead(before)) {
            const Field& field = *std::get<Leaf>(input.value).field;
            if (field.kind != Kind::number) {
                continue;
            }
            Project after = before;
            double& value = field.as<double>(findMember(after, input.path).owner);
            value = std::nextafter(value, std::numeric_limits<double>::max());
            const auto rows = compareRuns({{&before, nullptr}, {&after, nullptr}});
            QCOMPARE(pathsOf(rows), std::vector<std::string>{input.path});
            QVERIFY(!rows[0].isResult && rows[0].runs.size() == 2);
            const auto& shown = std::get<Leaf>(rows[0].runs[1]->value);
            QCOMPARE(shown.field->as<double>(shown.owner), value);
            ++changed;
        }
        QVERIFY(changed > 20);
    }

    void inputsThatTheModelDoesNotReadAreLeftOut() {
        Project a = traverse(), b = a;
        a.sections = 3; // of a plunge cycle
        b.sections = 7;
        b.runs.push_back({"Run 1", {}, {}, {}, {}});
        b.sweep.emplace();
        QVERIFY(compareRuns({{&a, nullptr}, {&b, nullptr}}).empty());
        a.operation = b.operation = Operation::plunge;
        QCOMPARE(pathsOf(compareRuns({{&a, nullptr}, {&b, nullptr}})),
                 std::vector<std::string>{"/sections"});
    }

    /// Half of the last digit stated, either way from the middle of what is stated alike, is no
    /// difference; one whole digit is, in each number of a summary.
    void resultsDifferInTheDigitsStated() {
        const Ran ran(traverse());
        int changed = 0;
        for (const RunValue& result : resultsStated(ran.summary)) {
            const Leaf* const leaf = std::get_if<Leaf>(&result.value);
            if (!leaf || leaf->field->kind != Kind::number) {
                continue;
            }
            const ResultDigits digits = digitsOf(*leaf->field);
            const double value = leaf->field->as<double>(leaf->owner);
            const int decimals =
                digits.decimals < 0 ? decimalsOf(value, digits.significant) : digits.decimals;
            const double digit = std::pow(10.0, -decimals);
            ReadSummary a = ran.summary, b = ran.summary;
            numberAt(a.summary, result.path) = std::round(value / digit) * digit;
            const auto differ = [&](double by) {
                numberAt(b.summary, result.path) = numberAt(a.summary, result.path) + by * digit;
                return pathsOf(compareRuns({{nullptr, &a}, {nullptr, &b}}));
            };
            QVERIFY2(differ(0.4).empty() && differ(-0.4).empty(), result.path.c_str());
            QCOMPARE(differ(1), std::vector<std::string>{result.path});
            ++changed;
        }
        QVERIFY(changed > 10);
    }

    void lengthsAreStatedToAHundredthAndTimesToFourDigits() {
        for (const Field& field : tableOf<RunSummary>().fields) {
            const std::string key = field.key;
            if (key == "cylindricity_um") {
                QCOMPARE(digitsOf(field).decimals, 2);
            } else if (key == "cycle_time_min" || key == "peak_power_w") {
                QVERIFY(digitsOf(field).decimals < 0);
                QCOMPARE(digitsOf(field).significant, key == "peak_power_w" ? 3 : 4);
            }
        }
    }

    /// What only one run has stands where it has it, in the order of the tables.
    void rowsStandInTheOrderOfTheTables() {
        const Ran a(traverse());
        Project longer = a.project;
        longer.cycle->stages.push_back(longer.cycle->stages.back());
        longer.wheel->width_mm *= 1.01;
        const Ran b(longer);
        for (const auto& runs :
             {std::vector{a.compared(), b.compared()}, std::vector{b.compared(), a.compared()}}) {
            const std::vector<ComparedRow> rows = compareRuns(runs);
            const std::vector<std::string> paths = pathsOf(rows);
            const std::vector<std::string> tables = pathsOf(inputsRead(b.project));
            auto at = tables.begin();
            int onlyInOne = 0, inputs = 0;
            for (const ComparedRow& row : rows) {
                QCOMPARE(row.runs.size(), 2u);
                QVERIFY(row.runs[0] || row.runs[1]);
                if (row.isResult) {
                    continue;
                }
                at = std::find(at, tables.end(), row.path);
                QVERIFY2(at != tables.end(), row.path.c_str());
                onlyInOne += row.runs[0] && row.runs[1] ? 0 : 1;
                ++inputs;
            }
            QVERIFY(onlyInOne > 2 && inputs > onlyInOne); // a whole stage, and the wheel
            QVERIFY(std::ranges::is_partitioned(
                rows, [](const ComparedRow& row) { return !row.isResult; }));
            QVERIFY(std::ranges::count(paths, "/cycle/stages") == 1);
            QVERIFY(std::ranges::count(paths, "/wheel/width_mm") == 1);
        }
    }

    void theLeastMarginLeavesOutRangesThatHoldAndASurfaceGroundInPart() {
        RunSummary summary;
        QVERIFY(!leastMargin(summary));
        const auto add = [&summary](ConstraintKind kind, double margin, bool ok) {
            RequirementSummary of;
            of.name = requirementOf(kind).key;
            of.relative_margin = margin;
            of.ok = ok;
            summary.requirements.push_back(of);
        };
        add(ConstraintKind::rangeAxialFeed, 0.001, true);
        QVERIFY(!leastMargin(summary));
        add(ConstraintKind::radialRunout, 0.4, true);
        add(ConstraintKind::diameterMax, 0.25, true);
        QCOMPARE(leastMargin(summary)->relativeMargin, 0.25);
        add(ConstraintKind::rangeWorkSpeed, -0.1, false);
        QCOMPARE(leastMargin(summary)->relativeMargin, -0.1);
        summary.requirements.push_back({"of another version", "", 0, 0, 0, -5, false});
        QCOMPARE(leastMargin(summary)->relativeMargin, -0.1);
        add(ConstraintKind::overlap, -0.05, false); // strips are left: the runout is of a part
        add(ConstraintKind::roundness, -0.3, false);
        QCOMPARE(leastMargin(summary)->kind, ConstraintKind::rangeWorkSpeed);
    }

    void marginsWorstAndVerdictAreThoseOfTheRun() {
        const Ran ran(traverse());
        const std::vector<RunValue> results = resultsStated(ran.summary, &ran.project);
        std::vector<ConstraintResult> counted = ran.constraints;
        std::erase_if(counted, [](const ConstraintResult& of) {
            return marginKnown(of) != MarginKnown::exactly
                   || (requirementOf(of.kind).source == LimitSource::range && of.holds);
        });
        QVERIFY(!counted.empty());
        const auto worst = std::ranges::min_element(counted, {}, &ConstraintResult::relativeMargin);
        const RunValue* const stated = find(results, "/worst");
        QVERIFY(stated);
        QCOMPARE(std::get<WorstMargin>(stated->value).requirement.kind, worst->kind);
        QCOMPARE(std::get<WorstMargin>(stated->value).requirement.margin, worst->margin);
        for (const RequirementSummary& requirement : ran.summary.summary.requirements) {
            const RunValue* const margin =
                find(results, "/requirements/" + requirement.name + "/margin");
            QVERIFY2(margin, requirement.name.c_str());
            QCOMPARE(std::get<RequirementMargin>(margin->value).requirement.margin,
                     requirement.margin);
        }
        Light light = verdictOf(RunStatus::completed, ran.constraints);
        if (!undecided(ran.project, ran.constraints).empty()) {
            light = std::max(light, Light::undecided);
        }
        QCOMPARE(std::get<Light>(find(results, "/verdict")->value), light);
        QVERIFY(verdictOf(ran.summary.summary, &ran.project) == light);
        QVERIFY(!verdictOf(RunSummary{}));
        RunSummary tooLong = ran.summary.summary;
        tooLong.status = RunStatus::tooLong;
        QVERIFY(verdictOf(tooLong) == Light::fails);
    }

    /// A summary has one value of Ra and none of the machine: what is not decided follows from the
    /// inputs that are kept with it, and is not known without them.
    void whatIsNotDecidedFollowsFromTheInputs() {
        Project project = traverse();
        project.part->upper_deviation_um = 200;
        project.part->lower_deviation_um = -200;
        project.part->tolerance = {};
        project.wheel->roughness_factor = 1;
        project.wheel->measured_ra.reset();
        project.measured.reset();
        const auto lightWith = [](const Project& of) {
            const Ran ran(of);
            return std::pair(verdictOf(ran.summary.summary, &ran.project),
                             verdictOf(ran.summary.summary));
        };
        QVERIFY(lightWith(project).first < Light::undecided);
        Project rough = project;
        rough.part->tolerance.roughness_ra_um = 100;
        const Ran first(rough);
        const auto of = std::ranges::find(first.constraints, ConstraintKind::roughness,
                                          &ConstraintResult::kind);
        rough.part->tolerance.roughness_ra_um = (of->value + of->mostValue.value()) / 2;
        QVERIFY(lightWith(rough).first == Light::undecided);
        QVERIFY(lightWith(rough).second < Light::undecided);
        Project round = project;
        round.machine->form.reset();
        round.part->tolerance.roundness_um = 1000;
        const Ran unknown(round);
        QVERIFY(lightWith(round).first == Light::undecided);
        const std::vector<RunValue> results = resultsStated(unknown.summary, &unknown.project);
        const RunValue* const margin = find(results, "/requirements/roundness/margin");
        QVERIFY(margin);
        QVERIFY(marginKnown(std::get<RequirementMargin>(margin->value).requirement)
                != MarginKnown::exactly);
        const auto worst = leastMargin(unknown.summary.summary, &unknown.project);
        QVERIFY(worst && worst->kind != ConstraintKind::roundness);
        round.machine->form.emplace().roundness_um = std::vector<double>(3, 0.5);
        QVERIFY(verdictOf(unknown.summary.summary, &round) < Light::undecided);
    }

    /// The places of a requirement are read as they are written.
    void aRequirementOfASummaryIsTheConstraint() {
        for (const char* name : {"smallest-traverse", "smallest-plunge"}) {
            const Ran ran(samples::project(name));
            for (const RequirementSummary& requirement : ran.summary.summary.requirements) {
                const std::optional<ConstraintResult> read =
                    constraintOf(requirement, true, &ran.project);
                QVERIFY(read);
                const auto same = [&read](const ConstraintResult& of) {
                    const int section = of.at ? of.at->section : of.section;
                    const Zone zone = of.at ? of.at->zone : of.zone;
                    const bool here =
                        section < 0 || (read->section == section && read->zone == zone);
                    return of.kind == read->kind && here && of.margin == read->margin
                           && lightOf(of) == lightOf(*read)
                           && (section >= 0 || of.stage == read->stage);
                };
                QVERIFY2(std::ranges::any_of(ran.constraints, same), requirement.name.c_str());
            }
        }
        QVERIFY(!constraintOf({"of a later version", "part"}));
    }

    void whereStripsStayUncutNothingIsStatedOfTheSurface() {
        Ran ran(traverse());
        const std::vector<std::string> whole = pathsOf(resultsStated(ran.summary));
        ran.summary.summary.requirements.push_back(
            {requirementOf(ConstraintKind::overlap).key, "cycle", 1, 0.9, -0.1, -0.1, false});
        const std::vector<std::string> strips = pathsOf(resultsStated(ran.summary));
        const auto has = [](const std::vector<std::string>& paths, const std::string& end) {
            return std::ranges::any_of(
                paths, [&end](const std::string& path) { return path.ends_with(end); });
        };
        for (const char* surface : {"/roundness_um", "/radial_runout_um", "/cylindricity_um",
                                    "/total_runout_um", "/diameter_deviation_min_um"}) {
            QVERIFY2(has(whole, surface) && !has(strips, surface), surface);
        }
        for (const char* pass : {"/cycle_time_min", "/peak_power_w", "/overlap/margin"}) {
            QVERIFY2(has(strips, pass), pass);
        }
    }

    void whatAnotherVersionDidNotWriteIsLeftOut() {
        Ran ran(traverse());
        const ReadSummary whole = ran.summary;
        ran.summary.missing = {"/cylindricity_um"};
        QVERIFY(!find(resultsStated(ran.summary), "/cylindricity_um"));
        const auto rows = compareRuns({{nullptr, &whole}, {nullptr, &ran.summary}});
        QCOMPARE(pathsOf(rows), std::vector<std::string>{"/cylindricity_um"});
        QVERIFY(rows[0].runs[0] && !rows[0].runs[1]);
    }

    void listsDifferByTheirLargestStep() {
        QCOMPARE(largestDifference({1, 2, 3}, {1.5, 0, 3}).value(), 2.0);
        QCOMPARE(largestDifference({}, {}).value(), 0.0);
        QVERIFY(!largestDifference({1}, {1, 2}));
    }

    /// A zone of another part belongs to the section whose slice holds its middle.
    void anotherKindOfRunIsMatchedAlongThePart() {
        const Ran zones(traverse());
        const Project plunge = samples::project("smallest-plunge");
        for (const int sections : {1, 3, 5, 40}) {
            RunSummary along;
            along.zones.resize(static_cast<std::size_t>(sections));
            for (int i = 0; i < sections; ++i) {
                along.zones[static_cast<std::size_t>(i)].position_mm =
                    plunge.part->length_mm * (i + 0.5) / sections;
            }
            const RunPlaces other{plunge, along};
            QVERIFY(!haveSamePlaces(zones.places(), other));
            for (std::size_t zone = 0; zone < 3; ++zone) {
                const double share =
                    zones.summary.summary.zones[zone].position_mm / zones.project.part->length_mm;
                QCOMPARE(matchingPlace(zones.places(), zone, other),
                         static_cast<std::size_t>(share * sections));
            }
        }
        QVERIFY(haveSamePlaces(zones.places(), zones.places()));
        for (const std::size_t zone : {0u, 1u, 2u}) {
            QCOMPARE(matchingPlace(zones.places(), zone, zones.places()), zone);
        }
    }
};

} // namespace sparkout::test_run_comparison

SPARKOUT_TEST(test_run_comparison, TestRunComparison)
#include "test_run_comparison.moc"
