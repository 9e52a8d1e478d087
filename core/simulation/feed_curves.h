// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_series.h"

#include <vector>

/// Feed points as curves over a chosen horizontal axis.
namespace sparkout {

enum class CycleAxis { time, strokes, revolutions };

/// Conversion of time to the chosen axis and back; both grow strictly. Time is in seconds or
/// minutes, by the longest that is shown, otherwise the whole cycle. Strokes are counted when done:
/// the first one runs from 0 to 1.
class CycleScale {
public:
    CycleScale() = default;
    CycleScale(const FeedSeries& series, CycleAxis axis) : CycleScale(series, axis, series.end_s) {}
    CycleScale(const FeedSeries& series, CycleAxis axis, double longest_s);
    [[nodiscard]] double at(double time_s) const;
    [[nodiscard]] double time_s(double x) const;

private:
    double m_factor = 1;
    std::vector<double> m_bounds_s; ///< starts of the strokes and the end; strokes axis only
};

enum class Quantity { programmed, actual, programmedSum, actualSum, came, left, axialFeed, force };
enum class Edge { low, mean, high };

struct XY {
    double x = 0, y = 0;
};

/// Returns the point at a time; null if the zone has none.
[[nodiscard]] const FeedPoint* feedPointAt(const FeedPoints& points, double time_s);

/// Returns a curve: feeds and forces as steps that fall to zero where the wheel is elsewhere,
/// accumulated feeds as ramps, radii as held steps. x never falls; all values are finite.
[[nodiscard]] std::vector<XY> polyline(const FeedPoints& points, Quantity quantity, Edge edge,
                                       const CycleScale& scale);

[[nodiscard]] double valueOf(const FeedPoint& point, Quantity quantity, Edge edge);

/// Returns the points that touch a time span, and one neighbour on each side.
[[nodiscard]] FeedPoints within(const FeedPoints& points, double from_s, double to_s);

} // namespace sparkout
