// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/line_chart.h"

#include <QCoreApplication>

namespace sparkout {

struct Part;

/// Common functions of the charts over the length of the part. Diameters are drawn relative to the
/// middle of the tolerance band.
class LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(LengthCurves)
public:
    static double middle_um(const Part& part); ///< middle of the tolerance band, from nominal
    static LineChart chart();                  ///< without series
    /// Adds the limits of the tolerance band over the length, ± half of it, after the series;
    /// visible unless they are far from the curves.
    static void addLimits(LineChart& chart, const Part& part, int key);
    /// Makes a series readable by the cursors if it runs along the part; of a band both edges.
    static void read(LineChart& chart, const ChartSeries& of, Digits digits);
};

} // namespace sparkout
