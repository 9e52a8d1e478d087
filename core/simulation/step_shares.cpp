// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/step_shares.h"

#include "core/simulation/progress.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

/// Whether a pass is simultaneous with another one: all zones of a stroke and all sections of a
/// revolution are ground at once.
bool isBeside(const Pass& pass) {
    const bool isStroke = pass.axialFeed_mm_min > 0;
    return pass.place.zone == Zone::section ? pass.place.section > 0
                                            : isStroke && pass.place.zone != Zone::rz1;
}

/// Mean depth of cut of a pass over the radii outside gaps, without NaN values.
double meanDepth(const Trajectory& trajectory, const Pass& pass) {
    double sum = 0;
    int ground = 0;
    for (int k = 0; k < trajectory.radii; ++k) {
        const Visit& visit = trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
        sum += std::isfinite(visit.actual_mm) ? visit.actual_mm : 0;
        ground += visit.isGap() ? 0 : 1;
    }
    return ground > 0 ? sum / ground : 0;
}

} // namespace

double StepSums::total() const {
    return std::accumulate(of.begin(), of.end(), 0.0);
}

StepShares stepShares(const SimulationResult& result, const Trajectory& trajectory) {
    StepShares shares;
    if (trajectory.passes.empty()) {
        return shares;
    }
    const std::size_t stages = result.timeByStage_s.size();
    shares.time_s.resize(stages);
    shares.removed_mm.assign(result.sections.size(), std::vector<StepSums>(stages));
    for (const Pass& pass : trajectory.passes) {
        const auto stage = static_cast<std::size_t>(std::max(pass.place.stage - 1, 0));
        const StrokeStep step = strokeStep(pass.place.zone, pass.place.step);
        if (!isBeside(pass)) {
            shares.time_s.at(stage)[step] += pass.duration_s;
        }
        shares.removed_mm.at(sectionOf(pass.place)).at(stage)[step] += meanDepth(trajectory, pass);
    }
    return shares;
}

} // namespace sparkout
