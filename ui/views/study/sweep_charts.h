// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/study/sweep_shown.h"

#include <QLineF>

#include <functional>
#include <vector>

namespace sparkout {

/// A sweep over one input: a curve for each zone or section, with gaps at points without values,
/// limits as lines, and shading where every requirement is met at adjacent points.
class SweepCurves {
    Q_DECLARE_TR_FUNCTIONS(SweepCurves)
public:
    static constexpr std::size_t mostCurves = 6; ///< of more, those with the least margin

    /// The chart; key i of the legend is curve i.
    static LineChart chart(const SweepShown& shown);

private:
    static void addCurves(LineChart& chart, const SweepShown& shown,
                          const std::vector<std::size_t>& quantities);
    static void addLimits(LineChart& chart, const SweepShown& shown,
                          const std::vector<std::size_t>& quantities);
    static void addMarks(LineChart& chart, const SweepShown& shown,
                         const std::vector<std::size_t>& quantities);
};

/// The zero lines of a function on a grid, as line segments: within each cell with four finite
/// corners, the zeros on its edges, interpolated linearly, are joined. A cell with a NaN corner has
/// none. The sign of the middle decides how a saddle is joined.
[[nodiscard]] std::vector<QLineF>
zeroLines(const std::vector<double>& across, const std::vector<double>& up,
          const std::function<double(std::size_t i, std::size_t j)>& at);

/// A sweep over two inputs: a coloured cell for each point, the worst of several zones; with lines
/// where the quantity meets its limit and around the cells in which every requirement is met.
class SweepMap {
    Q_DECLARE_TR_FUNCTIONS(SweepMap)
public:
    static LineChart chart(const SweepShown& shown);

private:
    static void addContours(LineChart& chart, const SweepShown& shown);
    static void addMarks(LineChart& chart, const SweepShown& shown);
};

} // namespace sparkout
