// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/phase_pieces.h"

#include "core/process/profile.h"
#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/plunge.h"
#include "core/simulation/traverse.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

std::unique_ptr<CycleSteps> stepsOf(const Project& project, const std::stop_token& stop) {
    return project.operation->hasZones ? traverseSteps(project, Zone::nz, nullptr, stop)
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

} // namespace sparkout
