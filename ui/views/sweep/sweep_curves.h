// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/sweep/sweep_shown.h"

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

} // namespace sparkout
