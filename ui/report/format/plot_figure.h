// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"
#include "ui/report/format/report.h"

class QCustomPlot;

/// Plots of the views as figures of a report. In the window's thread.
namespace sparkout::report {

/// Width of a figure in its own units.
inline constexpr int figureWidth = 820;

/// Sets up a plot for white paper, the same on every device; call before setting its data.
void setUpForPaper(QCustomPlot& plot, int height);

/// The plot as vector graphics, with its legend above.
[[nodiscard]] Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend,
                                const QString& caption, const QString& description);

} // namespace sparkout::report
