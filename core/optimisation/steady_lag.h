// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/radius_follower.h"

#include <cstddef>
#include <map>
#include <vector>

namespace sparkout {

/// How far radii stay behind the wheel when steps of one setting are made on and on.
///
/// The lag of a radius behind a step is w = t_П − depth: what of the infeed is not cut. The next
/// step makes W(w) of it. A pass leaves h − a(h) of the lag h before it, and a rises by no more
/// than h does, and ever faster (a = 0 up to h = 0): so W rises and is concave, and W(w) > w of a
/// radius that is not reached yet. Where W(ŵ) ≥ ŵ, then, no lag falls below the lesser of itself
/// and ŵ; where W(ŵ) ≤ ŵ, none rises beyond the greater, and one beyond comes as near in n steps as
/// the slope ρ of W there says: w_n ≤ ŵ + ρⁿ·(w_0 − ŵ). Both ŵ are sought next to the steady lag,
/// of which W(w) = w.
class SteadyLags {
public:
    struct Most {
        double lag_mm = 0; ///< ŵ with W(ŵ) ≤ ŵ
        double slope = 0;  ///< ρ: of W, no less than at ŵ and beyond
    };

    /// Of a follower, with its feeds by setting, and the zone or section that is gauged.
    SteadyLags(const RadiusFollower& follower, const std::vector<FollowedFeed>& feeds,
               std::size_t gauged)
        : m_follower(follower), m_feeds(feeds), m_gauged(gauged) {}

    /// By setting ŵ with W(ŵ) ≥ ŵ [mm], of a radius at the end of the revolution where it is
    /// gauged: the strokes alone cut there.
    [[nodiscard]] const std::vector<double>& least_mm();
    /// By setting, of all radii of a zone or section.
    [[nodiscard]] const std::vector<Most>& most(std::size_t zone);

private:
    const RadiusFollower& m_follower;
    const std::vector<FollowedFeed>& m_feeds;
    std::size_t m_gauged;
    std::vector<double> m_least_mm;                  ///< none: not asked for yet
    std::map<std::size_t, std::vector<Most>> m_most; ///< by zone
};

} // namespace sparkout
