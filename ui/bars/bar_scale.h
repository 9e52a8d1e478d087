// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct BarChart;

/// An axis of values: round steps from `below` steps under 0 to `above` over it.
struct BarScale {
    double step = 1;
    int below = 0, above = 1;

    [[nodiscard]] double low() const { return -below * step; }
    [[nodiscard]] double high() const { return above * step; }
    [[nodiscard]] double clamped(double value) const; ///< to the visible range
    /// The position of a value on the axis, from 0 to 1.
    [[nodiscard]] double share(double value) const;
};

/// Both axes of a chart, with equal steps and 0 at the same height.
struct BarScales {
    BarScale first, second;
};

/// For all drawn data, with about this number of steps; the axis includes 0 even for boxes.
[[nodiscard]] BarScales scalesOf(const BarChart& chart, int steps);

} // namespace sparkout
