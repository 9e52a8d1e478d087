// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_series.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// Sums up the passes of one zone or section in the order of time into the points of its column.
class FeedColumnBuilder {
public:
    /// `group` successive strokes become one point.
    FeedColumnBuilder(const FeedSeries& series, FeedColumn& column, std::size_t radii,
                      std::size_t group);
    void add(std::size_t index, const Pass& pass, const Visit* visits);
    int finish(); ///< closes the last stroke and returns the number of visits that were not finite

private:
    void openStroke(const Pass& pass, const Visit* visits);
    void closeStroke();
    void keepStroke();

    const FeedSeries& m_series;
    FeedColumn& m_column;
    std::size_t m_radii;
    std::size_t m_group;
    std::size_t m_strokes = 0; ///< number of strokes closed so far
    int m_dropped = 0;
    std::vector<double> m_fed_mm;        ///< t_П at the last visit of each radius
    std::vector<double> m_strokeFed_mm;  ///< t_П when the stroke began
    std::vector<double> m_strokeCut_mm;  ///< Σa within the stroke
    std::vector<double> m_strokeCame_mm; ///< radius when the stroke began
    const Visit* m_last = nullptr;       ///< visits of the stroke's latest pass
    FeedPoint m_stroke;
    bool m_open = false;
};

/// Returns a pass as a point; `before` are the visits of the column's previous pass, or null.
[[nodiscard]] FeedPoint passPoint(const FeedSeries& series, const Pass& pass, const Visit* visits,
                                  const Visit* before, std::size_t radii);

/// Returns one visit as a point; `before_mm` is t_П at the radius' previous visit.
[[nodiscard]] FeedPoint radiusPoint(const FeedSeries& series, const Pass& pass, const Visit& visit,
                                    double before_mm, std::size_t k, std::size_t radii);

} // namespace sparkout
