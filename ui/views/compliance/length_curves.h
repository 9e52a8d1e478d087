// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/line_chart.h"

#include <QCoreApplication>

namespace sparkout {

struct Part;

/// What the charts over the length of the part share. Diameters are drawn from the middle of the
/// tolerance band.
class LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(LengthCurves)
public:
    static double middle_um(const Part& part); ///< of the tolerance band, from nominal
    static LineChart chart();                  ///< without series
    /// The limits of the tolerance band over the length, ± half of it, after the series; in sight
    /// unless they are far from what is drawn.
    static void addLimits(LineChart& chart, const Part& part, int key);
    /// For the cursors, if it runs along the part; both edges of a band.
    static void read(LineChart& chart, const ChartSeries& of, Digits digits);
};

} // namespace sparkout
