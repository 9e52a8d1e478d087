// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/outcome.h"

#include "core/project/validate.h"
#include "core/quality/verdict.h"
#include "core/simulation/simulate.h"

#include <cstddef>

namespace sparkout {

OutcomePtr evaluate(const Project& project, const std::stop_token& stop) {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues = validate(project);
    if (hasErrors(outcome->issues)) {
        outcome->result.status = RunStatus::refused;
        return outcome;
    }
    // Runs once to count the records, then again to record: a run is short, and the longest
    // trajectories would not fit into memory.
    outcome->result = simulateUnchecked(project, nullptr, stop);
    if (!stop.stop_requested() && outcome->result.visits <= maxRecordedVisits) {
        outcome->trajectory.visits.reserve(static_cast<std::size_t>(outcome->result.visits));
        outcome->result = simulateUnchecked(project, &outcome->trajectory, stop);
    }
    constexpr int places = 241; // the resolution of a drawn curve
    outcome->compliance = complianceAlong(project, places, stop);
    if (stop.stop_requested() || outcome->result.status == RunStatus::stopped) {
        return nullptr;
    }
    addEvenLobes(outcome->result, stop);
    outcome->accuracy = accuracyOf(outcome->result);
    outcome->constraints = evaluateConstraints(outcome->result, outcome->accuracy);
    outcome->limits = makeLimitSeries(outcome->result, outcome->trajectory);
    outcome->shop = shopNumbers(outcome->result);
    const Issues remarks = remarksOn(outcome->result);
    outcome->issues.insert(outcome->issues.end(), remarks.begin(), remarks.end());
    outcome->feeds = makeFeedSeries(outcome->result, outcome->trajectory);
    outcome->layers = makeLayerSeries(outcome->result, outcome->trajectory);
    outcome->steps = stepShares(outcome->result, outcome->trajectory);
    return outcome;
}

} // namespace sparkout
