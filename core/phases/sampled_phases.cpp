// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/sampled_phases.h"

#include "core/project/part.h"
#include "core/quality/constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"
#include "core/simulation/stage_control.h"
#include "core/statistics/philox.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace sparkout {

std::optional<CycleTrial> tried(const Project& project, const std::stop_token& stop) {
    const SimulationResult result = simulateUnchecked(project, nullptr, stop);
    if (result.status == RunStatus::stopped) {
        return std::nullopt;
    }
    if (result.status != RunStatus::completed) {
        return CycleTrial{};
    }
    CycleTrial trial{true, std::numeric_limits<double>::infinity(), removedVolume_mm3(result)};
    for (const ConstraintResult& constraint : evaluateConstraints(result)) {
        trial.holds &= constraint.holds;
        trial.leastMargin = std::min(trial.leastMargin, constraint.relativeMargin);
    }
    return trial;
}

namespace {

/// Changes the stock by a share of an infeed, centred on its value.
void addPhase(Project& project, double infeed_mm, double share) {
    constexpr double leastShare = 0.01; // least share of the stock: a blank has some
    double& stock_mm = project.part->stock_mm;
    stock_mm = std::max(stock_mm + infeed_mm * (share - 0.5), leastShare * stock_mm);
}

} // namespace

std::vector<Project> stockPhases(const Project& project, int phases, double from) {
    std::vector<Project> spread;
    for (const double infeed_mm : fedByStep_mm(project)) {
        for (int i = 0; i < phases && infeed_mm > 0; ++i) {
            spread.push_back(project);
            addPhase(spread.back(), infeed_mm, (i + from) / phases);
        }
    }
    return spread;
}

std::optional<Project> failingPhase(const Project& best, std::uint32_t draw,
                                    const std::stop_token& stop, int count) {
    std::vector<double> infeeds_mm = fedByStep_mm(best);
    std::erase_if(infeeds_mm, [](double infeed_mm) { return infeed_mm <= 0; });
    Project drawn = best;
    drawn.runs.clear();
    std::optional<Project> worst;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count && !infeeds_mm.empty() && !stop.stop_requested(); ++i) {
        const auto unit = [&](std::uint32_t factor) {
            return openUnit(
                randomBits(draw, RandomStream::plain, static_cast<std::uint64_t>(i), factor));
        };
        const auto stage =
            static_cast<std::size_t>(unit(0) * static_cast<double>(infeeds_mm.size()));
        drawn.part->stock_mm = best.part->stock_mm;
        addPhase(drawn, infeeds_mm[stage], unit(1));
        const std::optional<CycleTrial> trial = tried(drawn, stop);
        if (trial && !trial->holds && (!worst || trial->leastMargin < least)) {
            worst = drawn;
            least = trial->leastMargin;
        }
    }
    return worst;
}

} // namespace sparkout
