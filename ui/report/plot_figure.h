// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report.h"
#include "ui/views/legend_drawing.h"

class QCustomPlot;

namespace sparkout::report {

/// Gives a plot of a view the look of paper: white, one font on every device, this size in the
/// units of the drawing. Before it is filled.
void preparePlot(QCustomPlot& plot, QSize size);

/// A filled plot in vectors, under its legend.
[[nodiscard]] Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend,
                                const QString& caption, const QString& told);

} // namespace sparkout::report
