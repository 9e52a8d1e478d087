// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/depth_limits.h"
#include "core/simulation/progress.h"
#include "core/simulation/stock_layers.h"
#include "core/simulation/trajectory.h"

#include <cstddef>
#include <optional>
#include <vector>

/// A run held against the limits of its feed, cut by cut: what the view "Constraints" draws.
namespace sparkout {

/// The cut of one pass that comes nearest to its limit, of all radii; without limits the deepest.
struct LimitedCut {
    Place place;
    int radius = 0;      ///< k
    double stock_mm = 0; ///< left after the cut, R_k over the target; negative beyond it
    double depth_mm = 0; ///< a > 0
    double width_mm = 0; ///< b
    double usage = 0;    ///< a over the least limit at this stock; above 1 it is exceeded
};

/// A stage of the cycle in one group: its width, and the limits that are the same at every stock.
struct LimitedStage {
    int stage = 1;
    double width_mm = 0;           ///< b
    double end_mm = 0;             ///< stock at which the next stage takes over
    std::vector<DepthLimit> fixed; ///< all but burn, by kind
};

/// The cuts of a zone or section at one kind of pass.
struct LimitGroup {
    Zone zone = Zone::section;
    int section = 0;
    bool standing = false;            ///< the wheel stands on the zone; else it travels
    std::vector<LimitedCut> cuts;     ///< in time, thinned to the nearest to their limit
    LimitedCut worst;                 ///< of all cuts the nearest to its limit
    std::vector<LimitedStage> stages; ///< that cut something, in order
};

struct LimitPoint {
    double stock_mm = 0;
    double depth_mm = 0;
};
using LimitPoints = std::vector<LimitPoint>;

struct LimitSeries {
    double deepest_mm = 0;          ///< the largest stock, Π + ΔR
    double least_mm = 0;            ///< the least stock any cut left, at most 0
    LimitPoints burn;               ///< limiting depth over the stock, rising; empty: off
    std::vector<LimitGroup> groups; ///< zones or sections; standing before travelling
    std::vector<ConstraintKind> on; ///< limits of the feed that are on
};

/// More cuts than this are merged in LimitGroup::cuts.
inline constexpr std::size_t mostLimitedCuts = 600;

/// Power is no limit of one section where the sections are coupled: they share it. Without a
/// trajectory there are no groups.
[[nodiscard]] LimitSeries makeLimitSeries(const SimulationResult& result,
                                          const Trajectory& trajectory);

/// Index of the group a cut belongs to; −1: none.
[[nodiscard]] int limitGroupAt(const LimitSeries& series, const Place& place);

/// The cut at which a requirement of the passes or of the last cut was worst; nothing for others,
/// and where it was not recorded.
[[nodiscard]] std::optional<LimitedCut> limitedCutOf(const SimulationResult& result,
                                                     const Trajectory& trajectory,
                                                     const ConstraintResult& requirement);

/// A limit over the stock, by rising stock; steps where a stage takes over. Empty when off.
[[nodiscard]] LimitPoints limitCurve(const LimitSeries& series, const LimitGroup& group,
                                     ConstraintKind kind);

/// The stepless limit: the greatest depth of cut allowed at each stock, the least of all limits but
/// roughness, which binds the last cut alone [MODEL-8]. Empty when no other limit is on.
[[nodiscard]] LimitPoints steplessLimit(const LimitSeries& series, const LimitGroup& group);

/// A limit of the depth of cut over the stock, by rising stock, linear between its points.
struct BoundCurve {
    LimitBound bound = LimitBound::requirement;
    ConstraintKind kind = ConstraintKind::burn; ///< of a requirement
    LimitPoints points;
};

/// Which of several limits binds where: stretches of the stock, rising, in each of which one of
/// them is the least, with its own points; the first of equal ones. A stock that none of them has
/// is in no stretch.
[[nodiscard]] std::vector<BoundCurve> envelopeOf(const std::vector<BoundCurve>& curves);

/// Whether a limit that binds every cut is on.
[[nodiscard]] bool limitsFeed(const LimitSeries& series);
/// The same of the cuts of one zone or section: coupled sections share the power.
[[nodiscard]] bool limitsGroups(const LimitSeries& series, const Project& project);

/// Stock left by the newest cut of a group at a moment of the cycle, at its deepest radius [mm].
[[nodiscard]] std::optional<double> stockAt(const LimitSeries& series, const LayerSeries& layers,
                                            const Trajectory& trajectory, int group,
                                            const Progress& moment);

} // namespace sparkout
