// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <optional>
#include <vector>

/// What the view "Feeds by stage" draws, computed from a trajectory; no Qt.
namespace sparkout {

/// Smallest, mean and largest value over the radii of a cross-section.
struct Spread {
    double min = 0, mean = 0, max = 0;
};

/// A stretch of time of one zone or section, summed up over its radii: one pass, one double
/// stroke, or (all three of a spread equal) one radius of one pass.
struct FeedPoint {
    Place place;
    int radius = -1; ///< k, when the point is of one radius only
    double start_s = 0;
    double end_s = 0;
    double axialFeed_mm_min = 0;
    Spread programmed_um;    ///< growth of t_П since the radius was last visited
    Spread actual_um;        ///< depth cut
    Spread programmedSum_um; ///< t_П at the end
    Spread actualSum_um;     ///< Σa at the end
    Spread came_um;          ///< radius before, less the target radius
    Spread left_um;          ///< radius after, less the target radius
    Spread force_n;          ///< P_y
};
using FeedPoints = std::vector<FeedPoint>;

/// One zone or section: a column of the view.
struct FeedColumn {
    Zone zone = Zone::section;
    int section = 0;
    bool gauge = false;                 ///< plunge: the section that carries the gauge
    std::vector<std::size_t> passIndex; ///< its passes in the trajectory, in time
    FeedPoints passes;                  ///< one point a pass
    FeedPoints strokes;                 ///< one point a double stroke or revolution, thinned
};

/// A stage as it was run; stages that ended before they began are not listed.
struct StageSpan {
    int stage = 1;
    double start_s = 0;
    double end_s = 0;
};

struct FeedSeries {
    Operation operation = Operation::traverse;
    double target_mm = 0;   ///< R_t
    double removalSign = 1; ///< R_came = R_left + sign·a: +1 external, −1 internal
    double revolutions_per_s = 0;
    double end_s = 0;
    int dropped = 0;                   ///< visits with a value that is no finite number, not drawn
    std::vector<double> strokeStart_s; ///< start of each double stroke or revolution
    std::vector<StageSpan> stages;
    std::vector<FeedColumn> columns;

    [[nodiscard]] int strokeCount() const { return static_cast<int>(strokeStart_s.size()); }
    [[nodiscard]] double strokeEnd_s(int number) const; ///< number counts from 1
    [[nodiscard]] int strokeAt(double time_s) const;    ///< number of the stroke, from 1
};

/// More points than this are merged in FeedColumn::strokes.
inline constexpr std::size_t mostStrokePoints = 500;

/// Section that carries the gauge (or stands nearest to it), 0-based.
[[nodiscard]] int gaugeSection(const SimulationResult& result);

/// At most `most` sections, evenly chosen, first and last and the gauge's among them; a wanted one
/// takes the place of its nearest neighbour that is not the gauge's.
[[nodiscard]] std::vector<int> shownSections(int count, int gauge, std::optional<int> wanted = {},
                                             int most = 4);

/// The series of a run; plunge: of the listed sections.
[[nodiscard]] FeedSeries makeFeedSeries(const SimulationResult& result,
                                        const Trajectory& trajectory,
                                        const std::vector<int>& sections = {});

/// One point a radius for the passes that touch the time span. The radii of a pass are spread
/// evenly over it in the order of their visits.
[[nodiscard]] FeedPoints radiusPoints(const FeedSeries& series, const FeedColumn& column,
                                      const Trajectory& trajectory, double from_s, double to_s);

// --- the horizontal axis ------------------------------------------------------------------------

enum class CycleAxis { minutes, seconds, strokes, revolutions };

/// Time to the chosen axis and back; both grow strictly. Strokes are counted as done: the first one
/// runs from 0 to 1.
class CycleScale {
public:
    CycleScale() = default;
    CycleScale(const FeedSeries& series, CycleAxis axis);
    [[nodiscard]] double at(double time_s) const;
    [[nodiscard]] double time_s(double x) const;

private:
    double m_factor = 1;
    std::vector<double> m_bounds_s; ///< starts of the strokes and the end; strokes axis only
};

// --- curves -------------------------------------------------------------------------------------

enum class Quantity { programmed, actual, programmedSum, actualSum, came, left, axialFeed, force };
enum class Edge { low, mean, high };

struct XY {
    double x = 0, y = 0;
};

/// Feeds and forces as steps that fall to zero where the wheel is elsewhere, accumulated feeds as
/// ramps, radii as held steps. x never falls, all values are finite.
[[nodiscard]] std::vector<XY> polyline(const FeedPoints& points, Quantity quantity, Edge edge,
                                       const CycleScale& scale);

[[nodiscard]] double valueOf(const FeedPoint& point, Quantity quantity, Edge edge);

/// The points that touch a time span, and one neighbour at each side.
[[nodiscard]] FeedPoints within(const FeedPoints& points, double from_s, double to_s);

} // namespace sparkout
