// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/line_chart.h"
#include "ui/views/sweep/phase_outcome.h"

#include <QCoreApplication>

namespace sparkout {

/// Size against stock: the largest and the smallest diameter of all zones or sections over the
/// stock, piece by piece, against the tolerance band; stocks that fail are hatched. Within a piece
/// the diameters are linear in the stock, so the picture is exact.
class PhaseChart {
    Q_DECLARE_TR_FUNCTIONS(PhaseChart)
public:
    enum Key { largestKey, smallestKey, toleranceKey, failsKey, statedKey }; ///< keys of the legend

    static LineChart of(const PhaseOutcomePtr& phases); ///< null: only axes

private:
    static ChartTable table(const PhaseDecision& decision);
};

} // namespace sparkout
