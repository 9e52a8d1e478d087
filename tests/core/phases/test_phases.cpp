// SPDX-License-Identifier: GPL-3.0-or-later
// The stocks of an interval by what their cycles do: a closed form, and stocks run one by one.
#include "core/phases/failing_stock.h"
#include "core/phases/phase_decision.h"
#include "core/phases/sampled_phases.h"
#include "core/simulation/stage_control.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/random_project.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <random>
#include <utility>

namespace sparkout::test_phases {

constexpr double fine_mm = 1e-9;

bool contains(const PhasePiece& piece, double stock_mm) {
    return piece.from_mm <= stock_mm && stock_mm <= piece.to_mm;
}

bool holdsAll(const SimulationResult& result) {
    return result.status == RunStatus::completed
           && std::ranges::all_of(evaluateConstraints(result), &ConstraintResult::holds);
}

/// What went wrong with a stock of a project; empty: nothing.
std::string wrongAt(const Project& project, const PhaseDecision& decision, double stock_mm) {
    Project made = project;
    made.part->stock_mm = stock_mm;
    const SimulationResult result = simulateUnchecked(made);
    const bool holds = holdsAll(result);
    bool found = false, agrees = false;
    for (const DecidedPiece& each : decision.pieces) {
        if (!contains(each.piece, stock_mm) || each.piece.counts != result.countsByStage) {
            continue;
        }
        found = true;
        if (each.piece.status != result.status) {
            return "another status";
        }
        const bool stated =
            each.holds && each.holds->from_mm <= stock_mm && stock_mm <= each.holds->to_mm;
        // Where the diameters change over, the slack of a limit decides.
        const bool isAtEnd = each.holds
                             && (std::abs(stock_mm - each.holds->from_mm) < 2 * diameterSlack_mm
                                 || std::abs(stock_mm - each.holds->to_mm) < 2 * diameterSlack_mm);
        agrees = agrees || stated == holds || isAtEnd;
        const double length_mm = each.piece.to_mm - each.piece.from_mm;
        const double share = length_mm > 0 ? (stock_mm - each.piece.from_mm) / length_mm : 0;
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            const auto between = [share](double low, double high) {
                return low + share * (high - low);
            };
            const DeviationRange &low = each.low.deviations[i], &high = each.high.deviations[i];
            if (!(std::abs(between(low.least_mm, high.least_mm)
                           - result.sections[i].diameterDeviationMin_mm)
                  < fine_mm)
                || !(std::abs(between(low.most_mm, high.most_mm)
                              - result.sections[i].diameterDeviationMax_mm)
                     < fine_mm)) {
                return "diameters are not linear";
            }
        }
    }
    return !found ? "in no piece" : !agrees ? "holds otherwise" : std::string();
}

/// What is wrong with the stock that fails by most: none where the decision has one, or another.
std::string wrongAboutFailing(const Project& project, const PhaseDecision& decision,
                              StockRange range) {
    const std::optional<Project> failing = failingStock(project, range);
    const std::optional<double> stock_mm =
        failing ? std::optional(failing->part->stock_mm) : std::nullopt;
    const std::vector<StockRange> ranges = decision.failingRanges();
    if (!stock_mm) {
        const bool isNone = std::ranges::all_of(ranges, [](const StockRange& each) {
            return each.to_mm - each.from_mm < 4 * diameterSlack_mm; // what a limit's slack lets by
        });
        return isNone ? std::string() : "a failing stock is missed";
    }
    const bool isIn = std::ranges::any_of(ranges, [&](const StockRange& each) {
        return each.from_mm <= *stock_mm && *stock_mm <= each.to_mm;
    });
    return isIn ? std::string() : "a stock that holds is called failing";
}

/// A stiff plunge on a round blank: each revolution removes what is fed.
Project rigidPlunge() {
    Project project = fixtures::plunge();
    project.machine->compliance_mm_per_n = std::vector<double>{1e-15};
    project.gauge->compliance_mm_per_n.reset();
    project.part->initial_runout_mm = 0;
    project.part->profile = ProfileForm::lobes;
    return project;
}

class TestPhases : public QObject {
    Q_OBJECT

private slots:
    /// A stage without an infeed at the reversals has a phase all the same: what its continuous
    /// infeed feeds during a double stroke.
    void aPhaseCountsTheContinuousInfeed() {
        constexpr double feed_mm_min = 0.02;
        Project project = fixtures::traverse();
        for (Stage& stage : project.cycle->stages) {
            stage.radial_feed_mm = 0;
            stage.continuous_feed_mm_min = feed_mm_min;
        }
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.status, RunStatus::completed);
        double most_mm = 0;
        for (std::size_t z = 0; z < result.timeByStage_s.size(); ++z) {
            if (result.countsByStage[z] > 0) {
                most_mm = std::max(most_mm, feed_mm_min / 60 * result.timeByStage_s[z]
                                                / result.countsByStage[z]);
            }
        }
        QVERIFY(most_mm > 1e-3);
        for (const Control control : {Control::gauge, Control::position}) {
            project.gauge->control = control;
            const StockRange range = usualPhases(project);
            const double phase_mm = range.to_mm - range.from_mm;
            QVERIFY2(phase_mm >= most_mm && phase_mm < 1.2 * most_mm,
                     qPrintable(QStringLiteral("%1 of %2").arg(phase_mm).arg(most_mm)));
            QCOMPARE(stockPhases(project, 4).size(), 4 * project.cycle->stages.size());
        }
    }

    /// Of a rigid system G_m of the deepest diameter is what has been fed to it, m·S − S/2·…: the
    /// ends of the pieces of one stage lie one infeed apart.
    void ofARigidSystemPiecesAreAnInfeedLong() {
        Project project = rigidPlunge();
        project.cycle->stages.resize(1);
        project.cycle->stages[0].stock_mm = project.part->stock_mm;
        const double infeed_mm = infeedsOfStages(project)[0];
        const double from_mm = project.part->stock_mm;
        const auto pieces = phasePieces(project, from_mm, from_mm + 5 * infeed_mm);
        QVERIFY(pieces.size() == 5 || pieces.size() == 6);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            QCOMPARE(pieces[i].status, RunStatus::completed);
            QCOMPARE(pieces[i].counts[0], pieces[0].counts[0] + static_cast<int>(i));
            if (i > 0 && i + 1 < pieces.size()) {
                QVERIFY(std::abs(pieces[i].to_mm - pieces[i].from_mm - infeed_mm) < fine_mm);
            }
        }
    }

    void piecesCoverTheInterval() {
        for (const char* name : {"smallest-plunge", "complete", "stiffness-traverse"}) {
            Project project = samples::project(name);
            project.gauge->control = Control::gauge;
            const StockRange range = usualPhases(project);
            const auto pieces = phasePieces(project, range.from_mm, range.to_mm);
            QVERIFY(!pieces.empty());
            QVERIFY(std::abs(pieces.front().from_mm - range.from_mm) < 1e-12);
            QVERIFY(std::abs(pieces.back().to_mm - range.to_mm) < 1e-12);
            double reached_mm = range.from_mm;
            for (const PhasePiece& piece : pieces) {
                QVERIFY(piece.from_mm <= reached_mm && piece.from_mm > reached_mm - 1e-6);
                QVERIFY(piece.to_mm >= piece.from_mm);
                reached_mm = std::max(reached_mm, piece.to_mm);
            }
        }
    }

    void everyStockIsAsItsPieceStates() {
        const int projects = samples::sized(60, 10, 400);
        const int stocks = samples::sized(60, 20, 400);
        int decided = 0, held = 0, failed = 0, tooMany = 0;
        std::mt19937_64 random(20261126);
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(projects); ++seed) {
            ReadResult read = readProject(randomProject(seed).dump());
            if (!read.project) {
                continue;
            }
            Project& project = *read.project;
            project.gauge->control = Control::gauge;
            project.gauge->datum_mm.reset();
            const StockRange range = usualPhases(project);
            const PhaseDecision decision = decidePhases(project, range);
            if (!decision.isDecided) {
                tooMany += decision.hasTooMany ? 1 : 0;
                continue; // else the control it is given now is refused
            }
            ++decided;
            const std::string missed = wrongAboutFailing(project, decision, range);
            QVERIFY2(missed.empty(), (std::to_string(seed) + ": " + missed).c_str());
            (decision.holds() ? held : failed) += 1;
            std::uniform_real_distribution<double> stock(range.from_mm, range.to_mm);
            for (int i = 0; i < stocks; ++i) {
                const double stock_mm = stock(random);
                const std::string wrong = wrongAt(project, decision, stock_mm);
                QVERIFY2(wrong.empty(),
                         (std::to_string(seed) + ": " + std::to_string(i) + ": " + wrong).c_str());
            }
        }
        QVERIFY(decided > projects / 2);
        QVERIFY(tooMany <= projects / 100);
        QVERIFY(held > 0 && failed > 0);
    }

    /// The ends of what fails are where stocks run by themselves change over.
    /// A last stage that comes to rest just where it would end: each of its steps splits the stocks
    /// that do so again, within rounding. The pieces were without end.
    void aStageThatComesToRestAtItsEndIsDecided() {
        Project project = samples::projectIn("tests/data/trials/rest-at-size.sparkout");
        for (const double stock_mm : {0.000204, 0.0001, 0.0003, 0.00018, 0.00025}) {
            project.cycle->stages.back().stock_mm = stock_mm;
            const StockRange range = usualPhases(project);
            const auto pieces = phasePieces(project, range.from_mm, range.to_mm, {}, 1000);
            QVERIFY(!pieces.empty() && pieces.size() < 100);
            double reached_mm = range.from_mm;
            for (const PhasePiece& piece : pieces) {
                QVERIFY(piece.from_mm <= reached_mm);
                reached_mm = std::max(reached_mm, piece.to_mm);
                const double middle_mm = (piece.from_mm + piece.to_mm) / 2;
                if (piece.to_mm - piece.from_mm < 1e-10) {
                    continue; // within rounding
                }
                Project made = project;
                made.part->stock_mm = middle_mm;
                const SimulationResult alone = simulateUnchecked(made);
                QCOMPARE(alone.status, piece.status);
                QVERIFY(alone.countsByStage == piece.counts);
            }
            QCOMPARE(reached_mm, range.to_mm);
        }
    }

    void failingStocksAreNamed() {
        Project project = samples::project("smallest-plunge");
        project.gauge->control = Control::gauge;
        const StockRange range = usualPhases(project);
        // A field as wide as half of what the size scatters by from stock to stock.
        const PhaseDecision wide = decidePhases(project, range);
        QVERIFY(wide.isDecided && !wide.pieces.empty());
        double least = 1, most = -1;
        for (const DecidedPiece& piece : wide.pieces) {
            least = std::min(least, piece.low.deviations[0].least_mm);
            most = std::max(most, piece.high.deviations[0].least_mm);
        }
        QVERIFY(most > least);
        constexpr double umPerMm = 1000;
        project.part->lower_deviation_um = (least + (most - least) / 4) * umPerMm;
        const PhaseDecision narrow = decidePhases(project, range);
        QVERIFY(narrow.isDecided && !narrow.failing.empty());
        int changes = 0;
        for (const FailingStocks& failing : narrow.failing) {
            QVERIFY(failing.worst.has_value());
            for (const auto& [stock_mm, beyond] :
                 {std::pair(failing.stocks.from_mm, -1), std::pair(failing.stocks.to_mm, 1)}) {
                Project inside = project, outside = project;
                constexpr double step_mm = 1e-7;
                inside.part->stock_mm = stock_mm - beyond * step_mm;
                outside.part->stock_mm = stock_mm + beyond * step_mm;
                if (outside.part->stock_mm < range.from_mm || outside.part->stock_mm > range.to_mm
                    || failing.stocks.to_mm - failing.stocks.from_mm < 2 * step_mm) {
                    continue;
                }
                QVERIFY(!holdsAll(simulateUnchecked(inside)));
                changes += holdsAll(simulateUnchecked(outside)) ? 1 : 0;
            }
        }
        QVERIFY(changes > 0);
    }

    /// Be the stretch that fails at the end of a piece as short as can be, a stock of it is found:
    /// of a shaft the small diameters fail at the low end, of a bore the large ones.
    void aShortStretchThatFailsIsFound() {
        Project bore = samples::projectIn("resources/examples/internal-plunge.sparkout");
        for (Project project : {samples::project("smallest-plunge"), std::move(bore)}) {
            project.gauge->control = Control::gauge;
            const StockRange range = usualPhases(project);
            const double middle_um =
                (project.part->upper_deviation_um + project.part->lower_deviation_um) / 2;
            constexpr double umPerMm = 1000;
            // Whatever the field, the same size is aimed at.
            project.part->target_diameter_mm = project.part->target_diameter_mm.value_or(
                project.part->diameter_mm + middle_um / umPerMm);
            project.part->lower_deviation_um = -1000;
            project.part->upper_deviation_um = 1000;
            project.part->tolerance = {};
            double least_mm = 1, most_mm = -1, widest_mm = 0;
            for (const DecidedPiece& piece : decidePhases(project, range).pieces) {
                for (const PieceEnd* end : {&piece.low, &piece.high}) {
                    for (const DeviationRange& each : end->deviations) {
                        least_mm = std::min(least_mm, each.least_mm);
                        most_mm = std::max(most_mm, each.most_mm);
                    }
                }
                widest_mm = std::max(widest_mm, piece.piece.to_mm - piece.piece.from_mm);
            }
            for (const double share : {0.0008, 0.003, 0.007, 0.012, 0.1}) {
                const double beyond_um = 2 * share * widest_mm * umPerMm;
                Project small = project, large = project;
                small.part->lower_deviation_um = least_mm * umPerMm + beyond_um;
                large.part->upper_deviation_um = most_mm * umPerMm - beyond_um;
                for (const Project& narrow : {small, large}) {
                    QCOMPARE(wrongAboutFailing(narrow, decidePhases(narrow, range), range),
                             std::string());
                    QVERIFY(failingStock(narrow, range).has_value());
                }
            }
        }
    }

    /// Of a uniform stock the share is a length over a length; where ranges overlap once.
    void theShareThatFailsIsThatOfTheDistribution() {
        const auto uniform = [](double from, double to) {
            return [=](double x) { return std::clamp((x - from) / (to - from), 0.0, 1.0); };
        };
        PhaseDecision made;
        made.isDecided = true;
        made.range = {0.1, 0.2};
        for (const StockRange& stocks : {StockRange{0.11, 0.12}, StockRange{0.119, 0.13},
                                         StockRange{0.125, 0.127}, StockRange{0.15, 0.16}}) {
            made.failing.push_back({stocks, RunStatus::completed, {}});
        }
        FailingShare shares = failingShare(made, uniform(0.1, 0.2));
        QVERIFY(std::abs(shares.failing - 0.3) < fine_mm && std::abs(shares.undecided) < fine_mm);
        shares = failingShare(made, uniform(0.125, 0.325));
        QVERIFY(std::abs(shares.failing - 0.075) < fine_mm);
        QVERIFY(std::abs(shares.undecided - 0.625) < fine_mm);
        // Of a project as many stocks run one by one, each for its share.
        Project project = samples::project("smallest-plunge");
        project.gauge->control = Control::gauge;
        const StockRange range = usualPhases(project);
        const PhaseDecision wide = decidePhases(project, range);
        const DeviationRange& size = wide.pieces.front().high.deviations[0];
        constexpr double umPerMm = 1000;
        project.part->lower_deviation_um = size.least_mm * umPerMm - 1;
        const PhaseDecision decision = decidePhases(project, range);
        constexpr int count = 2000;
        int failed = 0;
        for (int i = 0; i < count; ++i) {
            Project single = project;
            single.part->stock_mm =
                range.from_mm + (i + 0.5) / count * (range.to_mm - range.from_mm);
            failed += holdsAll(simulateUnchecked(single)) ? 0 : 1;
        }
        shares = failingShare(decision, uniform(range.from_mm, range.to_mm));
        QVERIFY(failed > 0 && failed < count);
        const auto ends = static_cast<double>(2 * decision.failing.size());
        QVERIFY(std::abs(shares.failing - double(failed) / count) <= ends / count);
    }

    void whatIsNotDecided() {
        Project project = samples::project("smallest-plunge");
        const StoppedSource stop;
        QVERIFY(!decidePhases(project, usualPhases(project), stop.get_token()).isDecided);
        project.gauge->control = Control::position;
        const PhaseDecision decision = decidePhases(project, usualPhases(project));
        QVERIFY(!decision.isDecided && !decision.holds() && decision.pieces.empty());
    }
};

} // namespace sparkout::test_phases

SPARKOUT_TEST(test_phases, TestPhases)
#include "test_phases.moc"
