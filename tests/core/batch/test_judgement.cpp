// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Whether a cycle is fit: each state once, the first that applies, its words and its JSON.
#include "core/batch/judgement.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "words/judgement_words.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace sparkout::test_judgement {

using nlohmann::json;

/// A requirement that holds by this share of its limit, or fails by it.
ConstraintResult held(ConstraintKind kind, double relativeMargin) {
    ConstraintResult constraint{kind};
    constraint.limit = 10;
    constraint.value = 10 - 10 * relativeMargin;
    constraint.margin = 10 * relativeMargin;
    constraint.relativeMargin = relativeMargin;
    constraint.holds = relativeMargin >= 0;
    return constraint;
}

/// A run that reached its size, of a project that asks for nothing that cannot be checked.
SimulationResult finished() {
    SimulationResult result;
    result.project = fixtures::plungeProject(3);
    result.project.part->tolerance.radial_runout_um.reset();
    return result;
}

JudgedStocks stocksOf(double failingShare, double relativeMargin) {
    return {{0.1, 0.2},
            failingShare == 0,
            failingShare,
            RunStatus::completed,
            held(ConstraintKind::diameterMax, relativeMargin)};
}

JudgedBatch batchOf(std::int64_t bad, double allowedShare = 0) {
    return {50, bad, 7, clopperPearson(bad, 50, 0.95), allowedShare, true};
}

/// All that may be known of a run, the gravest of which decides.
struct Known {
    RunStatus status = RunStatus::completed;
    double nominal = 0.5; ///< relative margin of the part that was run
    std::optional<JudgedStocks> stocks = stocksOf(0, 0.5);
    std::optional<JudgedBatch> batch = batchOf(0);
    bool hasBatch = false; ///< the project has one
    std::optional<MeasuredBias> measured{};
    bool asksRoughness = false;

    [[nodiscard]] Judgement judged() const {
        SimulationResult result = finished();
        result.status = status;
        if (asksRoughness) {
            result.project.part->tolerance.roughness_ra_um = 1.25;
        }
        if (hasBatch) {
            result.project.batch = Batch{};
        }
        return judge(result, {held(ConstraintKind::diameterMax, nominal)}, stocks, batch, measured);
    }
};

std::string headline(const Known& known) {
    return JudgementWording().headline(known.judged());
}

class TestJudgement : public QObject {
    Q_OBJECT

private slots:
    void eachStateBeatsThoseBehindIt() {
        Known known;
        known.stocks.reset();
        known.batch.reset();
        QCOMPARE(known.judged().state, JudgedState::nominal);
        QCOMPARE(headline(known), std::string("Nominal part only"));
        known.stocks = stocksOf(0, 0.5);
        QCOMPARE(known.judged().state, JudgedState::stocksHold);
        QCOMPARE(headline(known), std::string("Fit for every stock"));
        known.hasBatch = true;
        QCOMPARE(known.judged().state, JudgedState::batchNotRun);
        QCOMPARE(headline(known), std::string("Fit for every stock; batch not run"));
        known.batch = batchOf(0);
        QCOMPARE(known.judged().state, JudgedState::batchHolds);
        QCOMPARE(headline(known), std::string("Fit for the batch: rejected 0 of 50 (≤ 7.1 %)"));
        known.stocks = stocksOf(0, 0.04);
        QCOMPARE(known.judged().state, JudgedState::close);
        QCOMPARE(headline(known), std::string("Met, close to the limit: maximum diameter, 4.0 %"));
        known.stocks = stocksOf(0, 0.5);
        known.batch->lowPpk = Interval{0.72, 1.16};
        QCOMPARE(known.judged().state, JudgedState::close);
        QCOMPARE(headline(known), std::string("Met, Ppk of the batch too low: 0.72…1.16"));
        QCOMPARE(JudgementWording().batch(known.judged()),
                 std::string("Batch: rejected 0 of 50 (≤ 7.1 %); Ppk 0.72…1.16"));
        known.asksRoughness = true;
        QCOMPARE(known.judged().state, JudgedState::undecided);
        QCOMPARE(headline(known), std::string("Met, except roughness Ra: not decided"));
        known.measured = MeasuredBias{ConstraintKind::diameterMin, Zone::section, 1, -8.2};
        QCOMPARE(known.judged().state, JudgedState::measuredDiffer);
        QCOMPARE(headline(known), std::string("Met, but measured parts differ from the prediction: "
                                              "diameter, section 2, by -8.20 µm"));
        known.batch = batchOf(17);
        QCOMPARE(known.judged().state, JudgedState::batchFails);
        QCOMPARE(headline(known), std::string("Rejects in the batch: 17 of 50 (21…49 %)"));
        known.stocks = stocksOf(0.34, -0.107);
        QCOMPARE(known.judged().state, JudgedState::stocksFail);
        QCOMPARE(headline(known),
                 std::string("Unfit for 34 % of stocks: maximum diameter by 1.07 µm"));
        known.nominal = -1.07;
        QCOMPARE(known.judged().state, JudgedState::fails);
        QCOMPARE(headline(known), std::string("Not met: maximum diameter by 10.7 µm"));
        known.status = RunStatus::cannotReachSize;
        QCOMPARE(known.judged().state, JudgedState::fails);
        QCOMPARE(headline(known), std::string("Not met: the cycle does not end by itself"));
        known.status = RunStatus::refused;
        QCOMPARE(known.judged().state, JudgedState::notComputed);
        QCOMPARE(headline(known), std::string("Not computed: inputs refused"));
    }

    void batchHoldsWithAsManyRejectsAsAreAllowed() {
        Known known;
        known.batch = batchOf(2, 0.04);
        QCOMPARE(known.judged().state, JudgedState::batchHolds);
        QCOMPARE(headline(known), std::string("Fit for the batch: rejected 2 of 50 (0.5…14 %)"));
        known.batch = batchOf(3, 0.04);
        QCOMPARE(known.judged().state, JudgedState::batchFails);
    }

    void stoppedBatchFailsButDoesNotHold() {
        Known known;
        known.batch->isWhole = false;
        QCOMPARE(known.judged().state, JudgedState::batchNotRun);
        QCOMPARE(headline(known), std::string("Fit for every stock; batch run in part"));
        known.batch->bad = 1;
        QCOMPARE(known.judged().state, JudgedState::batchFails);
    }

    /// Whatever else is known, the state is that of all parts judged together.
    void batchThatWasRunLaterIsJudgedAlike() {
        Known known;
        known.hasBatch = true;
        for (const double nominal : {0.5, 0.04, -0.1}) {
            for (const double failingShare : {0.0, 0.34}) {
                for (const std::int64_t bad : {0, 17}) {
                    known.nominal = nominal;
                    known.stocks = stocksOf(failingShare, failingShare > 0 ? -0.1 : nominal);
                    known.batch = batchOf(bad);
                    const Judgement together = known.judged();
                    known.batch.reset();
                    const Judgement later = judgedWith(known.judged(), batchOf(bad));
                    QCOMPARE(later.state, together.state);
                    QCOMPARE(JudgementWording().headline(later),
                             JudgementWording().headline(together));
                }
            }
        }
    }

    void cornersHaveNoInterval() {
        Known known;
        known.batch->interval.reset();
        QCOMPARE(headline(known), std::string("Fit for the batch: rejected 0 of 50"));
    }

    void whatFailsEvenSoIsDecided() {
        Project project = finished().project;
        project.part->tolerance.roughness_ra_um = 1.25;
        project.part->tolerance.roundness_um = 4;
        const std::vector<Undecided> open = undecided(project, {});
        QCOMPARE(open.size(), std::size_t{2});
        QCOMPARE(open[0].kind, ConstraintKind::roundness);
        QCOMPARE(open[0].reason, UndecidedReason::machineNotKnown);
        QCOMPARE(open[0].path, std::string("/machine/form"));
        QCOMPARE(open[1].kind, ConstraintKind::roughness);
        QCOMPARE(open[1].reason, UndecidedReason::notCalibrated);
        const std::vector<Undecided> left =
            undecided(project, {held(ConstraintKind::roughness, -0.2)});
        QCOMPARE(left.size(), std::size_t{1});
        QCOMPARE(left[0].kind, ConstraintKind::roundness);
    }

    /// A range on one side of the limit decides, one around it does not, for any stock.
    void estimateIsDecidedByItsWholeRange() {
        Project project = finished().project;
        project.part->tolerance.roughness_ra_um = 1.25;
        ConstraintResult below = held(ConstraintKind::roughness, 0.5);
        below.limit = 1.25;
        below.value = 0.4;
        below.mostValue = 1.2;
        QVERIFY(undecided(project, {below}).empty());
        ConstraintResult around = below;
        around.mostValue = 1.3;
        const std::vector<Undecided> open = undecided(project, {below, around});
        QCOMPARE(open.size(), std::size_t{1});
        QCOMPARE(open[0].kind, ConstraintKind::roughness);
        SimulationResult result = finished();
        result.project = project;
        JudgedStocks stocks = stocksOf(0, 0.5);
        QCOMPARE(judge(result, {below}, stocks).state, JudgedState::stocksHold);
        stocks.hasOpenEstimate = true;
        QCOMPARE(judge(result, {below}, stocks).state, JudgedState::undecided);
    }

    void limitOfWhichAnInputIsMissingIsNotDecided() {
        Project project = finished().project;
        project.wheel->grain_modulus_gpa = 300;
        const std::vector<Undecided> open = undecided(project, {});
        QCOMPARE(open.size(), std::size_t{1});
        QCOMPARE(open[0].kind, ConstraintKind::selfSharpening);
        QCOMPARE(open[0].reason, UndecidedReason::inputMissing);
        QCOMPARE(open[0].path, std::string("/wheel/grain_surface_energy_j_m2"));
        project.wheel->grain_modulus_gpa.reset();
        QVERIFY(undecided(project, {}).empty());
    }

    /// The waviness needs the runout of the wheel.
    void wavinessOfAnUnknownWheelIsNotDecided() {
        Project project = finished().project;
        project.part->tolerance.waviness_um = 1;
        const auto only = [&] {
            const std::vector<Undecided> open = undecided(project, {});
            return open.size() == 1 && open[0].kind == ConstraintKind::waviness ? open[0]
                                                                                : Undecided{};
        };
        QCOMPARE(only().reason, UndecidedReason::inputMissing);
        QCOMPARE(only().path, std::string("/wheel/runout"));
        project.wheel->runout = WheelRunout{.amplitude_um = 1};
        project.part->radii_per_section = radiiForWaves(project);
        QVERIFY(undecided(project, {}).empty());
        ConstraintResult unknown = held(ConstraintKind::waviness, 0.5);
        unknown.knowsMachine = false;
        QVERIFY(lightOf(unknown) == Light::undecided);
    }

    void settingWithinItsRangeIsNotSpokenOf() {
        const Judgement judgement = judge(finished(), {held(ConstraintKind::rangeWorkSpeed, 0),
                                                       held(ConstraintKind::diameterMax, 0.5)});
        QCOMPARE(judgement.worst->kind, ConstraintKind::diameterMax);
        QCOMPARE(judgement.state, JudgedState::nominal);
    }

    /// Against the decision that it rests on, of a field that narrows until some stocks fail.
    void stocksAreThoseOfThePhases() {
        bool hasFailed = false, hasHeld = false;
        for (const double field_um : {40.0, 4.0, 2.0, 1.0, 0.5}) {
            Project project = fixtures::plungeProject(3);
            project.part->upper_deviation_um = field_um / 2;
            project.part->lower_deviation_um = -field_um / 2;
            const SimulationResult result = simulate(project);
            const PhaseDecision decision = decidePhases(project, usualPhases(project));
            const std::optional<JudgedStocks> stocks = judgeStocks(result);
            QVERIFY(stocks.has_value());
            QCOMPARE(stocks->holds, decision.holds());
            QCOMPARE(stocks->range.from_mm, decision.range.from_mm);
            double failing_mm = 0, least = 1;
            for (const StockRange& range : decision.failingRanges()) {
                failing_mm += range.to_mm - range.from_mm;
            }
            for (const DecidedPiece& piece : decision.pieces) {
                least = std::min(least, piece.leastMargin);
            }
            const double width_mm = decision.range.to_mm - decision.range.from_mm;
            QVERIFY(std::abs(stocks->failingShare - failing_mm / width_mm) < 1e-9);
            QCOMPARE(stocks->worst->relativeMargin, least);
            hasFailed = hasFailed || !stocks->holds;
            hasHeld = hasHeld || stocks->holds;
        }
        QVERIFY(hasFailed && hasHeld);
    }

    /// An odd number of lobes leaves every diameter as it is, an even one does not: where it is not
    /// known and matters, nothing is said to hold.
    void unknownLobesThatMatterAreNotDecided() {
        Project project = fixtures::plungeProject(3);
        project.part->radii_per_section = 36;
        project.part->upper_deviation_um = 2;
        project.part->lower_deviation_um = -2;
        const auto places = static_cast<std::size_t>(project.sections);
        project.machine->form.emplace().roundness_um = std::vector<double>(places, 3);
        project.machine->form->runout_um = std::vector<double>(places, 3); // of the lobes alone
        project.part->tolerance = {};
        const auto judgedWith = [&project](std::optional<int> lobes) {
            project.machine->form->lobes = lobes;
            const SimulationResult result = simulate(project);
            return judge(result, evaluateConstraints(result), judgeStocks(result));
        };
        QVERIFY2(!hasErrors(validate(project)), samples::listed(validate(project)).c_str());
        const Judgement odd = judgedWith(3), even = judgedWith(2), unknown = judgedWith({});
        QVERIFY(odd.stocks && unknown.stocks);
        QVERIFY(odd.stocks->holds && odd.notDecided.empty());
        QVERIFY(isFailure(even.state));
        QVERIFY(unknown.stocks->holds);
        QVERIFY(unknown.state == JudgedState::undecided);
        QCOMPARE(unknown.notDecided.size(), std::size_t{1});
        QCOMPARE(unknown.notDecided.front().path, std::string("/machine/form/lobes"));
        project.machine->form->roundness_um = std::vector<double>(places, 0.01);
        project.machine->form->runout_um = std::vector<double>(places, 0.01);
        QVERIFY(judgedWith({}).notDecided.empty()); // too little to matter
    }

    void stocksOfPositionControlAreNotDecided() {
        Project project = fixtures::plungeProject(3);
        project.gauge->control = Control::position;
        project.gauge->datum_mm = 0;
        const SimulationResult result = simulate(project);
        QVERIFY(!judgeStocks(result).has_value());
        SimulationResult refused = result;
        refused.status = RunStatus::refused;
        QVERIFY(!judgeStocks(refused).has_value());
    }

    void stocksOfACycleOfTooManyVisitsAreNotDecided() {
        SimulationResult result = simulate(fixtures::plungeProject(3));
        result.visits = mostJudgedVisits;
        QVERIFY(!judgeStocks(result).has_value());
    }

    void jsonStatesAllThatIsKnown() {
        const SimulationResult result = simulate(fixtures::plungeProject(3));
        const auto constraints = evaluateConstraints(result);
        const Judgement judgement = judge(result, constraints, judgeStocks(result), batchOf(0));
        const json answer = json::parse(judgedResultJson(result, constraints, judgement));
        QVERIFY(answer.at("constraints").is_array());
        const json& judged = answer.at("judged");
        QCOMPARE(judged.at("headline").get<std::string>(), JudgementWording().headline(judgement));
        QCOMPARE(judged.at("state").get<std::string>(), std::string(stateKey(judgement.state)));
        QCOMPARE(judged.at("nominal").get<bool>(), judgement.isNominalGood());
        const json& stocks = judged.at("stocks");
        QVERIFY(stocks.at("decided").get<bool>());
        QCOMPARE(stocks.at("holds").get<bool>(), judgement.stocks->holds);
        QCOMPARE(stocks.at("stock_mm")[1].get<double>(), judgement.stocks->range.to_mm);
        QCOMPARE(stocks.at("failing_share").get<double>(), judgement.stocks->failingShare);
        QCOMPARE(stocks.at("worst").at("relative_margin").get<double>(),
                 judgement.stocks->worst->relativeMargin);
        QCOMPARE(judged.at("batch").at("parts").get<int>(), 50);
        QCOMPARE(judged.at("batch").at("seed").get<int>(), 7);
        QCOMPARE(judged.at("batch").at("bad").get<int>(), 0);
        QVERIFY(std::abs(judged.at("batch").at("interval_95")[1].get<double>() - 0.0711) < 1e-4);
        const json& open = judged.at("not_decided");
        QCOMPARE(open.size(), std::size_t{1});
        QCOMPARE(open[0].at("name").get<std::string>(), std::string("radial_runout"));
        QCOMPARE(open[0].at("why").get<std::string>(), std::string("machine_not_known"));
        const json alone =
            json::parse(judgedResultJson(result, constraints, judge(result, constraints)))
                .at("judged");
        QVERIFY(alone.at("batch").is_null());
        QVERIFY(!alone.at("stocks").at("decided").get<bool>());
        QVERIFY(alone.at("stocks").at("holds").is_null());
        QVERIFY(alone.at("stocks").at("worst").is_null());
    }
};

} // namespace sparkout::test_judgement

SPARKOUT_TEST(test_judgement, TestJudgement)
#include "test_judgement.moc"
