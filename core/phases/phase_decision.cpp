// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/phase_decision.h"

#include "core/file/output_json.h"
#include "core/process/profile.h"
#include "core/process/wheel_wave.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/plunge.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

std::unique_ptr<CycleSteps> stepsOf(const Project& project, const std::stop_token& stop) {
    return project.operation->travels ? traverseSteps(project, Zone::nz, nullptr, stop)
                                      : plungeSteps(project, nullptr, stop);
}

constexpr double rounding_mm = 1e-12;

/// Follows the cycles of an interval of stocks, as offsets from its lower end.
class PhaseWalk {
public:
    PhaseWalk(Project project, double from_mm, double to_mm, const PieceVisitor& visit,
              std::stop_token stop)
        : m_project(std::move(project)), m_visit(visit), m_stop(std::move(stop)) {
        m_project.part->stock_mm = from_mm;
        m_overlap_mm = formChange_mm(m_project, to_mm - from_mm) + rounding_mm;
        std::unique_ptr<CycleSteps> steps = stepsOf(m_project, m_stop);
        CycleLoop loop(m_project, steps->run());
        m_branches.push_back({std::move(steps), std::move(loop), 0, to_mm - from_mm, {}, {}});
    }

    /// Whether all were visited.
    bool visit() {
        while (!m_branches.empty()) {
            Branch branch = std::move(m_branches.back());
            m_branches.pop_back();
            if (!follow(branch)) {
                return false;
            }
        }
        return true;
    }

private:
    /// Stocks with the same steps so far. If the last step has split them it has to be judged
    /// again, with the answers given already.
    struct Branch {
        std::unique_ptr<CycleSteps> steps;
        CycleLoop loop;
        double low_mm, high_mm;
        StepReading last;
        std::vector<bool> answers;
        double left_mm = 0; ///< additional stock below its cuts in the run
        /// The stocks are larger by more than this, as decided in the running stage. If a stage
        /// comes to rest near its end, each further step would otherwise split them again.
        double denied_mm = -std::numeric_limits<double>::infinity();
    };

    bool follow(Branch& branch) {
        if (!branch.answers.empty()) {
            judge(branch);
        }
        Run& run = branch.steps->run();
        leaveMore(branch);
        while (!branch.loop.finished() && !branch.loop.isStuck() && !run.mustEnd()) {
            if (!branch.steps->step(branch.loop.next(run))) {
                break;
            }
            branch.last = takeReading(*branch.steps);
            judge(branch);
            leaveMore(branch);
        }
        if (branch.loop.isStuck()) {
            run.setStatus(RunStatus::cannotReachSize);
        }
        const double from_mm = m_project.part->stock_mm;
        const std::vector<int>& counts = branch.loop.control().stepsByStage();
        const SimulationResult result = branch.steps->finish(counts);
        return !m_stop.stop_requested()
               && m_visit(
                   {from_mm + branch.low_mm, from_mm + branch.high_mm, counts, result.status},
                   result);
    }

    /// Adds the additional stock of the branch, relative to the least of the interval, below its
    /// cuts.
    static void leaveMore(Branch& branch) {
        if (branch.low_mm > branch.left_mm) {
            branch.steps->run().leaveMore(branch.low_mm - branch.left_mm);
            branch.left_mm = branch.low_mm;
        }
    }

    /// Continues with the stocks for which the loop's next question is true, and leaves the others
    /// for later.
    void judge(Branch& branch) {
        const std::vector<bool> known = std::exchange(branch.answers, {});
        m_before = branch.loop;
        m_given.clear();
        branch.loop.stepDone(branch.last, [&](double larger_mm) {
            if (m_given.size() < known.size()) {
                m_given.push_back(known[m_given.size()]);
                return static_cast<bool>(m_given.back());
            }
            if (larger_mm <= branch.denied_mm + rounding_mm) {
                m_given.push_back(false);
                return false;
            }
            const bool some = branch.low_mm <= larger_mm + m_overlap_mm;
            const bool others = branch.high_mm > larger_mm - m_overlap_mm;
            if (some && others) {
                std::vector<bool> answers = m_given;
                answers.push_back(false);
                m_branches.push_back({branch.steps->copy(), *m_before,
                                      std::max(branch.low_mm, larger_mm - m_overlap_mm),
                                      branch.high_mm, branch.last, std::move(answers),
                                      branch.left_mm, larger_mm});
                branch.high_mm = std::min(branch.high_mm, larger_mm + m_overlap_mm);
            }
            m_given.push_back(some);
            if (some) { // the next stage asks of another size
                branch.denied_mm = -std::numeric_limits<double>::infinity();
            }
            return some;
        });
    }

    Project m_project;
    const PieceVisitor& m_visit;
    std::stop_token m_stop;
    double m_overlap_mm = 0;
    std::vector<Branch> m_branches;
    std::optional<CycleLoop> m_before; ///< the loop before the step that is judged
    std::vector<bool> m_given;         ///< answers of that step
};

/// Decides on one piece.
class PieceJudge {
public:
    PieceJudge(const Project& project, PhasePiece piece, std::stop_token stop)
        : m_project(project), m_stop(std::move(stop)) {
        m_decided.piece = std::move(piece);
    }

    DecidedPiece decide() {
        const PhasePiece& piece = m_decided.piece;
        m_decided.low = endAt(piece.from_mm);
        m_decided.high = endAt(piece.to_mm);
        if (piece.status != RunStatus::completed || m_decided.low.constraints.empty()
            || m_decided.low.constraints.size() != m_decided.high.constraints.size()) {
            m_decided.leastMargin = piece.status == RunStatus::completed ? 0 : -1;
            if (piece.status == RunStatus::completed) { // nothing is required
                m_decided.holds = StockRange{piece.from_mm, piece.to_mm};
            }
            return std::move(m_decided);
        }
        StockRange holds{piece.from_mm, piece.to_mm};
        for (std::size_t i = 0; i < m_decided.low.constraints.size(); ++i) {
            narrow(holds, i);
        }
        if (holds.from_mm <= holds.to_mm) {
            m_decided.holds = holds;
        }
        return std::move(m_decided);
    }

private:
    PieceEnd endAt(double stock_mm) {
        const SimulationResult result = simulatePiece(m_project, m_decided.piece, stock_mm, m_stop);
        PieceEnd end;
        for (const SectionResult& section : result.sections) {
            end.deviations.push_back(
                {section.diameterDeviationMin_mm, section.diameterDeviationMax_mm});
        }
        m_decided.time_s = result.time_s;
        if (result.status == RunStatus::completed) {
            end.constraints = evaluateConstraints(result);
        }
        return end;
    }

    /// Restricts the range to stocks for which this requirement is met, too.
    void narrow(StockRange& holds, std::size_t index) {
        const ConstraintResult& low = m_decided.low.constraints[index];
        const ConstraintResult& high = m_decided.high.constraints[index];
        for (const ConstraintResult* each : {&low, &high}) {
            if (!m_decided.worst || each->relativeMargin < m_decided.worst->relativeMargin) {
                m_decided.worst = *each;
                m_decided.leastMargin = each->relativeMargin;
            }
        }
        if (low.holds && high.holds) {
            return;
        }
        if (!low.holds && !high.holds) {
            holds.to_mm = holds.from_mm - 1; // none
            return;
        }
        const double change = changeBetween(low, high, index);
        if (low.holds) {
            holds.to_mm = std::min(holds.to_mm, change);
        } else {
            holds.from_mm = std::max(holds.from_mm, change);
        }
    }

    /// The last stock for which it is met. Diameters are linear; otherwise by bisection.
    double changeBetween(const ConstraintResult& low, const ConstraintResult& high,
                         std::size_t index) {
        const PhasePiece& piece = m_decided.piece;
        if (low.kind == ConstraintKind::diameterMin || low.kind == ConstraintKind::diameterMax) {
            const double share = low.margin / (low.margin - high.margin);
            return piece.from_mm + std::clamp(share, 0.0, 1.0) * (piece.to_mm - piece.from_mm);
        }
        double held = low.holds ? piece.from_mm : piece.to_mm;
        double failed = low.holds ? piece.to_mm : piece.from_mm;
        constexpr int halvings = 40;
        for (int i = 0; i < halvings && !m_stop.stop_requested(); ++i) {
            const double middle = held + (failed - held) / 2;
            const PieceEnd end = endAt(middle);
            const bool holds = index < end.constraints.size() && end.constraints[index].holds;
            (holds ? held : failed) = middle;
        }
        return held;
    }

    const Project& m_project;
    std::stop_token m_stop;
    DecidedPiece m_decided;
};

std::optional<Interval> endsOf(const StockRange& range) {
    return Interval{range.from_mm, range.to_mm};
}

constexpr Output<PhaseDecision> decisionRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "range of stocks per side"},
     [](const PhaseDecision& d) { return endsOf(d.range); }},
    {{.key = "decided"}, [](const PhaseDecision& d) { return d.isDecided; }},
    {{.key = "too_many_pieces", .hint = "whether the range has too many pieces and is not decided"},
     [](const PhaseDecision& d) { return d.hasTooMany; }},
    {{.key = "holds", .hint = "whether every requirement is met for every stock of the range"},
     [](const PhaseDecision& d) { return d.holds(); }},
};

constexpr Output<DecidedPiece> pieceRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "stocks per side whose cycles make the same steps"},
     [](const DecidedPiece& p) {
         return endsOf({p.piece.from_mm, p.piece.to_mm});
     }},
    {{.key = "status"},
     [](const DecidedPiece& p) { return std::string(statusKey(p.piece.status)); }},
    {{.key = "time_min", .unit = "min", .hint = "time of the cycle"},
     [](const DecidedPiece& p) { return p.time_s / units::secondsPerMinute; }},
    {{.key = "holds_mm", .unit = "mm", .hint = "stocks for which every requirement is met"},
     [](const DecidedPiece& p) { return p.holds ? endsOf(*p.holds) : std::nullopt; }},
};

constexpr Output<FailingStocks> failingRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "stocks per side for which the cycle is unfit"},
     [](const FailingStocks& f) { return endsOf(f.stocks); }},
    {{.key = "status"}, [](const FailingStocks& f) { return std::string(statusKey(f.status)); }},
    {{.key = "wheel_deg", .unit = "°", .hint = "angle of a wheel out of true at which they fail"},
     [](const FailingStocks& f) { return f.wheel_deg; },
     nullptr,
     [](const FailingStocks& f) { return f.wheel_deg.has_value(); }},
};

constexpr Output<ConstraintResult> worstRows[] = {
    {{.key = "name"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).key); }},
    {{.key = "where"}, [](const ConstraintResult& c) { return whereText(c); }},
    {{.key = "relative_margin", .hint = "at the worse end; positive when the requirement is met"},
     [](const ConstraintResult& c) { return c.relativeMargin; }},
};

ordered_json deviationsJson(const PieceEnd& end) {
    ordered_json json = ordered_json::array();
    for (const DeviationRange& each : end.deviations) {
        json.push_back({each.least_mm * units::umPerMm, each.most_mm * units::umPerMm});
    }
    return json;
}

} // namespace

double formChange_mm(const Project& project, double stock_mm) {
    const double share = largestRunout(*project.part) / targetRadius(*project.part);
    return 2 * share * share * stock_mm;
}

bool visitPhasePieces(const Project& project, double from_mm, double to_mm,
                      const PieceVisitor& visit, const std::stop_token& stop) {
    assert(from_mm <= to_mm);
    return PhaseWalk(project, from_mm, to_mm, visit, stop).visit();
}

std::vector<PhasePiece> phasePieces(const Project& project, double from_mm, double to_mm,
                                    const std::stop_token& stop, std::size_t most) {
    std::vector<PhasePiece> pieces;
    const auto keep = [&pieces, most](const PhasePiece& piece, const SimulationResult&) {
        pieces.push_back(piece);
        return pieces.size() <= most;
    };
    if (!visitPhasePieces(project, from_mm, to_mm, keep, stop)) {
        return {};
    }
    std::ranges::sort(
        pieces, {}, [](const PhasePiece& piece) { return std::pair(piece.from_mm, piece.to_mm); });
    return pieces;
}

SimulationResult simulatePiece(const Project& project, const PhasePiece& piece, double stock_mm,
                               const std::stop_token& stop) {
    Project made = project;
    made.part->stock_mm = stock_mm;
    const std::unique_ptr<CycleSteps> steps = stepsOf(made, stop);
    CycleLoop loop(made, steps->run());
    bool goesOn = true;
    for (const int count : piece.counts) {
        for (int i = 0; goesOn && i < count; ++i) {
            goesOn = !steps->run().mustEnd() && steps->step(loop.next(steps->run()));
        }
        loop.endStage();
    }
    if (goesOn && piece.status == RunStatus::cannotReachSize) {
        steps->run().setStatus(piece.status);
    }
    return steps->finish(piece.counts);
}

std::vector<StockRange> DecidedPiece::failing() const {
    if (!holds) {
        return {{piece.from_mm, piece.to_mm}};
    }
    std::vector<StockRange> ranges;
    if (holds->from_mm > piece.from_mm) {
        ranges.push_back({piece.from_mm, holds->from_mm});
    }
    if (holds->to_mm < piece.to_mm) {
        ranges.push_back({holds->to_mm, piece.to_mm});
    }
    return ranges;
}

std::vector<StockRange> PhaseDecision::failingRanges() const {
    std::vector<StockRange> ranges;
    for (const FailingStocks& each : failing) { // neighbouring pieces overlap
        if (ranges.empty() || each.stocks.from_mm > ranges.back().to_mm) {
            ranges.push_back(each.stocks);
        }
        ranges.back().to_mm = std::max(ranges.back().to_mm, each.stocks.to_mm);
    }
    return ranges;
}

bool canDecidePhases(const Project& project) {
    return project.gauge->control == Control::gauge;
}

StockRange widened(const StockRange& stocks, double largestInfeed_mm) {
    constexpr double leastShare = 0.01; // least share of the stock: a blank has some
    return {std::max(stocks.from_mm - largestInfeed_mm / 2, leastShare * stocks.from_mm),
            stocks.to_mm + largestInfeed_mm / 2};
}

StockRange usualPhases(const Project& project) {
    double most_mm = 0;
    for (const double infeed_mm : fedByStep_mm(project)) {
        most_mm = std::max(most_mm, infeed_mm);
    }
    return widened({project.part->stock_mm, project.part->stock_mm}, most_mm);
}

DecidedPiece decidePiece(const Project& project, PhasePiece piece, const std::stop_token& stop) {
    return PieceJudge(project, std::move(piece), stop).decide();
}

namespace {

/// With the wheel at the phase that the project states.
PhaseDecision decideAtPhase(const Project& project, StockRange range, const std::stop_token& stop,
                            std::size_t mostPieces) {
    PhaseDecision decision;
    decision.range = range;
    if (!canDecidePhases(project) || hasErrors(validate(project))) {
        return decision;
    }
    std::vector<PhasePiece> pieces =
        phasePieces(project, range.from_mm, range.to_mm, stop, mostPieces);
    decision.hasTooMany = pieces.empty() && !stop.stop_requested();
    for (PhasePiece& piece : pieces) {
        decision.pieces.push_back(decidePiece(project, std::move(piece), stop));
        const DecidedPiece& decided = decision.pieces.back();
        for (const StockRange& stocks : decided.failing()) {
            decision.failing.push_back({stocks, decided.piece.status, decided.worst});
        }
    }
    decision.isDecided = !decision.hasTooMany && !stop.stop_requested();
    return decision;
}

} // namespace

std::vector<Project> atOtherWheelPhases(const Project& project) {
    constexpr double turn_deg = 360;
    std::vector<Project> turned;
    for (int i = 1; i < phasesOfWheel && wheelWave(project); ++i) {
        double& phase_deg = turned.emplace_back(project).wheel->runout->phase_deg;
        phase_deg = std::fmod(phase_deg + i * turn_deg / phasesOfWheel, turn_deg);
    }
    return turned;
}

PhaseDecision decidePhases(const Project& project, StockRange range, const std::stop_token& stop,
                           std::size_t mostPieces) {
    PhaseDecision decision = decideAtPhase(project, range, stop, mostPieces);
    if (!wheelWave(project)) {
        return decision;
    }
    for (FailingStocks& each : decision.failing) {
        each.wheel_deg = project.wheel->runout->phase_deg;
    }
    for (const Project& turned : atOtherWheelPhases(project)) {
        if (!decision.isDecided) {
            break;
        }
        const PhaseDecision other = decideAtPhase(turned, range, stop, mostPieces);
        decision.isDecided = other.isDecided;
        decision.hasTooMany = other.hasTooMany;
        for (FailingStocks each : other.failing) {
            each.wheel_deg = turned.wheel->runout->phase_deg;
            decision.failing.push_back(std::move(each));
        }
    }
    std::ranges::stable_sort(decision.failing, {},
                             [](const FailingStocks& each) { return each.stocks.from_mm; });
    return decision;
}

FailingShare failingShare(const PhaseDecision& decision,
                          const std::function<double(double)>& shareBelow) {
    const StockRange& range = decision.range;
    FailingShare shares{0, 1 - (shareBelow(range.to_mm) - shareBelow(range.from_mm))};
    for (const StockRange& each : decision.failingRanges()) {
        shares.failing += shareBelow(each.to_mm) - shareBelow(each.from_mm);
    }
    return shares;
}

std::span<const Output<PhaseDecision>> phasesOutputs() {
    return decisionRows;
}

std::span<const Output<DecidedPiece>> phasePieceOutputs() {
    return pieceRows;
}

std::span<const Output<FailingStocks>> failingStocksOutputs() {
    return failingRows;
}

std::span<const Output<ConstraintResult>> phaseWorstOutputs() {
    return worstRows;
}

std::string phasesJson(const PhaseDecision& decision) {
    ordered_json json = outputsJson(phasesOutputs(), decision);
    json["pieces"] = outputsJsonOfEach(phasePieceOutputs(), decision.pieces);
    json["failing"] = outputsJsonOfEach(failingStocksOutputs(), decision.failing);
    for (std::size_t i = 0; i < decision.pieces.size(); ++i) {
        const DecidedPiece& piece = decision.pieces[i];
        json["pieces"][i].update({{"steps_by_stage", piece.piece.counts},
                                  {"deviations_um_from", deviationsJson(piece.low)},
                                  {"deviations_um_to", deviationsJson(piece.high)},
                                  {"worst", outputsJson(phaseWorstOutputs(), piece.worst)}});
    }
    for (std::size_t i = 0; i < decision.failing.size(); ++i) {
        json["failing"][i]["worst"] = outputsJson(phaseWorstOutputs(), decision.failing[i].worst);
    }
    return json.dump(2) + '\n';
}

} // namespace sparkout
