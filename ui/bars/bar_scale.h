// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct BarChart;

/// An axis of values: round steps from `below` of them under 0 to `above` over it.
struct BarScale {
    double step = 1;
    int below = 0, above = 1;

    [[nodiscard]] double low() const { return -below * step; }
    [[nodiscard]] double high() const { return above * step; }
    [[nodiscard]] double clamped(double value) const; ///< to what is in sight
    /// How far along the axis a value lies, from 0 to 1.
    [[nodiscard]] double share(double value) const;
};

/// Both axes of a chart: equal steps and 0 stand at the same height.
struct BarScales {
    BarScale first, second;
};

/// Of all that is drawn, in about so many steps; a box need not stand on 0, but the axis does.
[[nodiscard]] BarScales scalesOf(const BarChart& chart, int steps);

} // namespace sparkout
