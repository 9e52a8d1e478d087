// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <optional>
#include <vector>

/// A trajectory summed up over the radii, for the view "Feeds by stage".
namespace sparkout {

/// Smallest, mean and largest value over the radii of a cross-section.
struct Spread {
    double min = 0, mean = 0, max = 0;
};

/// One zone or section within a span of time, summed up over its radii: one double stroke or
/// revolution, one pass, or (with equal values of a spread) one radius of one pass.
struct FeedPoint {
    Place place;
    int radius = -1; ///< k of a point of one radius; −1: all radii
    double start_s = 0;
    double end_s = 0;
    double axialFeed_mm_min = 0;
    Spread programmed_um;    ///< growth of t_П since the radius was last visited
    Spread actual_um;        ///< depth cut
    Spread programmedSum_um; ///< t_П at the end
    Spread actualSum_um;     ///< Σa at the end
    Spread came_um;          ///< radius before, less the target radius
    Spread left_um;          ///< radius after, less the target radius
    Spread force_n;          ///< P_y; of a double stroke: smallest, largest mean of a pass, largest
};
using FeedPoints = std::vector<FeedPoint>;

/// One zone or section: a column of the view.
struct FeedColumn {
    Zone zone = Zone::section;
    int section = 0;
    bool gauge = false;                 ///< plunge: the section that carries the gauge
    std::vector<std::size_t> passIndex; ///< its passes in the trajectory, in the order of time
    FeedPoints strokes;                 ///< one point for each double stroke or revolution, thinned
};

/// A stage that was run; stages without a step are not listed.
struct StageSpan {
    int stage = 1;
    double start_s = 0;
    double end_s = 0;
};

/// A step E1…E5 of one double stroke in one zone.
struct StepSpan {
    Place place; ///< place of its first pass
    double start_s = 0;
    double end_s = 0;
};

/// All zones or sections of a run; the passes within a time span are computed on demand.
struct FeedSeries {
    Operation operation;
    double target_mm = 0;    ///< R_t
    double firstFeed_mm = 0; ///< t_П at the beginning
    double removalSign = 1;  ///< R_came = R_left + sign·a: +1 external, −1 internal
    double revolutions_per_s = 0;
    double end_s = 0;
    int dropped = 0; ///< number of visits with a value that is not finite; they are not drawn
    std::vector<double> strokeStart_s; ///< start of each double stroke or revolution
    std::vector<StageSpan> stages;
    std::vector<FeedColumn> columns; ///< zones, or all sections from the headstock on

    [[nodiscard]] int strokeCount() const { return static_cast<int>(strokeStart_s.size()); }
    [[nodiscard]] double strokeEnd_s(int number) const; ///< number counts from 1
    [[nodiscard]] int strokeAt(double time_s) const;    ///< number of the stroke, from 1
};

/// Greatest number of points in FeedColumn::strokes; more are merged.
inline constexpr std::size_t mostStrokePoints = 500;

/// Returns the series of a run; its columns are empty when the trajectory was not recorded.
[[nodiscard]] FeedSeries makeFeedSeries(const SimulationResult& result,
                                        const Trajectory& trajectory);

/// Returns at most `most` evenly distributed sections, with the first, the last and the gauge's
/// among them; a requested one replaces its nearest neighbour that is not the gauge's.
[[nodiscard]] std::vector<int> shownSections(int count, int gauge, std::optional<int> wanted = {},
                                             int most = 4);

/// Returns one point for each pass that touches the time span, and for one neighbour on each side.
[[nodiscard]] FeedPoints passPoints(const FeedSeries& series, const FeedColumn& column,
                                    const Trajectory& trajectory, double from_s, double to_s);

/// Returns the steps whose passes touch the time span, and one on each side.
[[nodiscard]] std::vector<StepSpan>
stepSpans(const FeedColumn& column, const Trajectory& trajectory, double from_s, double to_s);

/// Returns one point for each radius of the passes that touch the time span. The radii of a pass
/// are distributed evenly over it in the order of their visits.
[[nodiscard]] FeedPoints radiusPoints(const FeedSeries& series, const FeedColumn& column,
                                      const Trajectory& trajectory, double from_s, double to_s);

} // namespace sparkout
