// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/sweep/sweep_shown.h"

namespace sparkout {

/// A sweep over one input: a curve a zone or section, gaps where there is no number, the limits as
/// lines, and shaded where every requirement holds from point to point.
class SweepCurves {
    Q_DECLARE_TR_FUNCTIONS(SweepCurves)
public:
    static constexpr std::size_t mostCurves = 6; ///< of more sections those of the least margin

    /// Key i of the legend is curve i.
    static LineChart chart(const SweepShown& shown);

private:
    static void addCurves(LineChart& chart, const SweepShown& shown,
                          const std::vector<std::size_t>& quantities);
    static void addLimits(LineChart& chart, const SweepShown& shown,
                          const std::vector<std::size_t>& quantities);
    static void addMarks(LineChart& chart, const SweepShown& shown,
                         const std::vector<std::size_t>& quantities);
};

} // namespace sparkout
