// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"
#include "core/simulation/stock_layers.h"

#include <cstddef>
#include <optional>
#include <vector>

/// A run compared with the limits of its feed, cut by cut, as the view "Constraints" shows it.

namespace sparkout {

/// The greatest depth of cut that a requirement allows.
struct DepthLimit {
    ConstraintKind kind;
    double depth_mm = 0; ///< 0: not met at any depth
};

/// The limit on a cut.
enum class LimitBound {
    feed,        ///< the machine's greatest infeed, which no cut of uncoupled lanes exceeds
    accuracy,    ///< the last cut that the drawing allows: release
    requirement, ///< a requirement on every pass: burn, self-sharpening, power
    stock,       ///< no limit: all stock left at once
};
/// The key in files: machine_feed, accuracy, stock, or that of the requirement.
[[nodiscard]] const char* limitBoundKey(LimitBound bound, ConstraintKind kind);

/// The greatest infeed of a step [mm] that the machine's range allows, where no cut is greater: for
/// uncoupled places without wheel contact and continuous infeed, a cut satisfies a + γ·P(a) = γ·P(a
/// of the pass before) + Δt, and so a ≤ f from rest on. Empty without a range, or where this is not
/// proved.
[[nodiscard]] std::optional<double> greatestInfeed_mm(const Project& project);

/// For a pass of the effective width b [mm] with this stock left [mm], the greatest depth of cut
/// [mm] by each requirement that is on and limits it, in the order of the kinds; as a feed it is
/// S_lim = a·n [MODEL-8]. Roughness limits the last cut alone. The least of the others is the
/// stepless limit at this stock.
[[nodiscard]] std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock);

/// The limit that binds a cut: the least of those on every cut; null if there is none.
[[nodiscard]] const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits);

/// The requirements that limit the depth of cut: first those on every pass, then those on the last
/// cut alone.
[[nodiscard]] std::vector<ConstraintKind> depthLimitKinds();

/// Whether the wheel dwells on its zone in this step: plunge-in and dwells [MODEL-5].
[[nodiscard]] bool wheelStands(const Place& place);

/// The effective width b of the pass at a place of the cycle [mm]: L_p in plunge; the wheel on the
/// reversal zone in its plunge passes, min(S_ax/n, B) in a stroke [MODEL-5].
[[nodiscard]] double effectiveWidth(const Project& project, const Place& place);

/// The cut of one pass nearest to its limit, of all radii; without limits the deepest.
struct LimitedCut {
    Place place;
    int radius = 0;      ///< k
    double stock_mm = 0; ///< stock left after the cut, R_k over the target; negative beyond it
    double depth_mm = 0; ///< a > 0
    double width_mm = 0; ///< b
    double usage = 0;    ///< a divided by the least limit at this stock; exceeded above 1
};

/// A stage of the cycle in one group: its width, and the limits independent of the stock.
struct LimitedStage {
    int stage = 1;
    double width_mm = 0;           ///< b
    double end_mm = 0;             ///< stock at which the next stage takes over
    std::vector<DepthLimit> fixed; ///< limits other than burn, by kind
};

/// The cuts of a zone or section at one kind of pass.
struct LimitGroup {
    Zone zone = Zone::section;
    int section = 0;
    bool standing = false;            ///< the wheel dwells on the zone; otherwise it travels
    std::vector<LimitedCut> cuts;     ///< in time order, thinned to the nearest to their limit
    LimitedCut worst;                 ///< the cut nearest to its limit
    std::vector<LimitedStage> stages; ///< stages with a cut, in order
};

struct LimitPoint {
    double stock_mm = 0;
    double depth_mm = 0;
};
using LimitPoints = std::vector<LimitPoint>;

struct LimitSeries {
    double deepest_mm = 0;          ///< the largest stock, Π + ΔR
    double least_mm = 0;            ///< least stock left by any cut, at most 0
    LimitPoints burn;               ///< limiting depth over rising stock; empty: off
    std::vector<LimitGroup> groups; ///< zones or sections; standing before travelling
    std::vector<ConstraintKind> on; ///< limits of the feed that are on
};

/// More cuts than this are merged in LimitGroup::cuts.
inline constexpr std::size_t mostLimitedCuts = 600;

/// With coupled sections power is not a limit of a single section, since they share it. Without a
/// trajectory there are no groups.
[[nodiscard]] LimitSeries makeLimitSeries(const SimulationResult& result,
                                          const Trajectory& trajectory);

/// Index of the group of a cut; −1 if it has none.
[[nodiscard]] int limitGroupAt(const LimitSeries& series, const Place& place);

/// The worst cut for a requirement on the passes or on the last cut; empty for other requirements,
/// and where it was not recorded.
[[nodiscard]] std::optional<LimitedCut> limitedCutOf(const SimulationResult& result,
                                                     const Trajectory& trajectory,
                                                     const ConstraintResult& requirement);

/// A limit over the stock, by rising stock; with a step at each change of stage. Empty when off.
[[nodiscard]] LimitPoints limitCurve(const LimitSeries& series, const LimitGroup& group,
                                     ConstraintKind kind);

/// The stepless limit: the greatest depth of cut allowed at each stock, the least of all limits
/// except roughness, which applies to the last cut alone [MODEL-8]. Empty when no other limit is
/// on.
[[nodiscard]] LimitPoints steplessLimit(const LimitSeries& series, const LimitGroup& group);

/// A limit of the depth of cut over the stock, by rising stock, linear between its points.
struct BoundCurve {
    LimitBound bound = LimitBound::requirement;
    ConstraintKind kind = ConstraintKind::burn; ///< used for a requirement
    LimitPoints points;
};

/// The lower envelope of several limits: consecutive stretches of rising stock, each with the
/// points of the least limit, the first of equal ones. A stock without any limit is in no stretch.
[[nodiscard]] std::vector<BoundCurve> envelopeOf(const std::vector<BoundCurve>& curves);

/// Whether a limit that binds every cut is on.
[[nodiscard]] bool limitsFeed(const LimitSeries& series);
/// Whether a limit that binds every cut of a single zone or section is on: coupled sections share
/// the power.
[[nodiscard]] bool limitsGroups(const LimitSeries& series, const Project& project);

/// Stock left by the latest cut of a group at a moment of the cycle, at its deepest radius [mm].
[[nodiscard]] std::optional<double> stockAt(const LimitSeries& series, const LayerSeries& layers,
                                            const Trajectory& trajectory, int group,
                                            const Progress& moment);

} // namespace sparkout
