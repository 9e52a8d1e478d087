// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit_proposal.h"

#include <algorithm>
#include <set>

namespace sparkout {

std::vector<FittedKind> proposedParameters(const FitData& data, bool hasThreshold) {
    const bool size = data.has(FitSource::size), power = data.has(FitSource::power);
    const bool force = data.has(FitSource::force), parts = data.has(FitSource::parts);
    std::vector<FittedKind> kinds;
    if (force && (size || parts)) {
        kinds = {FittedKind::compliance, FittedKind::flow_stress, FittedKind::dullness};
    } else if (force) {
        kinds = {FittedKind::flow_stress, FittedKind::dullness};
    } else if (size) {
        kinds = {FittedKind::alpha, FittedKind::beta};
    } else if (parts) {
        // Sizes in one place determine either the gauge's setting or the compliance, not both.
        kinds = {power ? FittedKind::compliance : FittedKind::gauge_setting};
        std::set<int> places;
        for (const FitGroup& group : data.groups) {
            places.insert(group.places.begin(), group.places.end());
        }
        if (places.size() > 1 && !power) {
            kinds.insert(kinds.begin(), FittedKind::beta);
        }
    }
    if (hasThreshold) {
        std::ranges::replace(kinds, FittedKind::flow_stress, FittedKind::alpha);
        std::ranges::replace(kinds, FittedKind::dullness, FittedKind::beta);
    }
    if (power) {
        kinds.insert(kinds.end(), {FittedKind::chip_power, FittedKind::friction_power});
        const bool isStated = std::ranges::any_of(
            data.groups, [](const FitGroup& group) { return group.idle_kw.has_value(); });
        if (!isStated) {
            kinds.push_back(FittedKind::idle_power);
        }
    }
    if (size) {
        kinds.push_back(FittedKind::size_offset);
    }
    if (size || power || force) {
        kinds.push_back(FittedKind::time_shift);
    }
    return kinds;
}

} // namespace sparkout
