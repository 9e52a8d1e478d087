// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/radius_follower.h"

#include <cstddef>
#include <map>
#include <vector>

namespace sparkout {

/// Lags of radii behind the wheel when steps of one setting are repeated.
///
/// The lag of a radius after a step is w = t_П − depth, the infeed that is not cut. The next step
/// changes it to W(w). A pass leaves h − a(h) of the lag h before it, and a rises by no more than h
/// does, and ever faster (a = 0 up to h = 0): so W rises and is concave, and W(w) > w for a radius
/// that is not reached yet. Hence, where W(ŵ) ≥ ŵ, no lag falls below the lesser of itself and ŵ;
/// where W(ŵ) ≤ ŵ, none rises beyond the greater, and a lag beyond ŵ approaches it in n steps with
/// the slope ρ of W there: w_n ≤ ŵ + ρⁿ·(w_0 − ŵ). Both ŵ are sought next to the steady lag, where
/// W(w) = w.
class SteadyLags {
public:
    struct Most {
        double lag_mm = 0; ///< ŵ with W(ŵ) ≤ ŵ
        double slope = 0;  ///< ρ: not below the slope of W at ŵ and beyond
    };

    /// Takes a follower, its feeds by setting, and the gauged zone or section.
    SteadyLags(const RadiusFollower& follower, const std::vector<FollowedFeed>& feeds,
               std::size_t gauged)
        : m_follower(follower), m_feeds(feeds), m_gauged(gauged) {}

    /// Returns, by setting, ŵ with W(ŵ) ≥ ŵ [mm] for a gauged radius at the end of the revolution,
    /// where only the strokes cut.
    [[nodiscard]] const std::vector<double>& least_mm();
    /// Returns the upper bounds of the lags of all radii of a zone or section, by setting.
    [[nodiscard]] const std::vector<Most>& most(std::size_t zone);

private:
    const RadiusFollower& m_follower;
    const std::vector<FollowedFeed>& m_feeds;
    std::size_t m_gauged;
    std::vector<double> m_least_mm;                  ///< empty: not computed yet
    std::map<std::size_t, std::vector<Most>> m_most; ///< by zone
};

} // namespace sparkout
