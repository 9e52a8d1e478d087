// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/threshold_pass.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// Puts each lane of the range into the state found by `stateOf`; returns the largest √a.
template <class StateOf>
double cutEach(Lanes& lanes, const PassRange& range, const StateOf& stateOf) {
    double largest = 0;
    for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
        const ThresholdState state = stateOf(lane);
        putState(lanes, lane, state);
        largest = std::max(largest, state.root);
    }
    return largest;
}

} // namespace

ThresholdState thresholdState(double C, double A4, double h) {
    if (h > C) {
        return {std::sqrt(4 * (h - C) / A4), h > 0 ? 1.0 : 0.0};
    }
    return {0, h > 0 ? h / C : 0};
}

void putState(Lanes& lanes, std::size_t lane, const ThresholdState& state) {
    const auto [u, v] = state;
    lanes.depth_mm[lane] += u * u;
    lanes.root[lane] = u;
    lanes.rubbing[lane] = v;
    lanes.rootSum[lane] += v;
    lanes.peakRoot[lane] = std::max(lanes.peakRoot[lane], u);
    lanes.peakRubbing[lane] = std::max(lanes.peakRubbing[lane], v);
}

double cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                        const PassRange& range) {
    return cutEach(lanes, range, [&](std::size_t lane) {
        const double h = std::max(0.0, feed.at(lanes.share[lane]) - lanes.depth_mm[lane]);
        return thresholdState(coefficients.C[lane], coefficients.A4[lane], h);
    });
}

double cutAsGiven(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& /*feed*/,
                  const PassRange& range) {
    return cutEach(lanes, range, [&](std::size_t lane) {
        return ThresholdState{std::sqrt(coefficients.C2[lane]), coefficients.C[lane]};
    });
}

} // namespace sparkout
