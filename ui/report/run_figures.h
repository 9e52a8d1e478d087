// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/chart/legend.h"
#include "ui/report/format/report.h"

#include <optional>

class QCustomPlot;

/// Plots of the views as figures of a report. Must run in the window's thread.
namespace sparkout::report {

/// Width of a figure in its own units.
inline constexpr int figureWidth = 820;

/// Sets up a plot for white paper, the same on every device; call before setting its data.
void setUpForPaper(QCustomPlot& plot, int height);

/// The plot as vector graphics, with its legend above.
[[nodiscard]] Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend,
                                const QString& caption, const QString& description);

/// The feeds of the whole cycle by zone or section; empty if it was too long to record.
[[nodiscard]] std::optional<Figure> feedsFigure(const OutcomePtr& outcome);
/// The feeds within a span of time, with a line at a moment.
[[nodiscard]] std::optional<Figure> feedsFigure(const OutcomePtr& outcome, double from_s,
                                                double to_s, std::optional<double> moment_s,
                                                const QString& caption);

/// The cross-sections at the end of the cycle, magnified.
[[nodiscard]] Figure profilesFigure(const OutcomePtr& outcome);

/// The actual feed over the stock left below its limits, at a place of the cycle; empty without
/// cuts.
[[nodiscard]] std::optional<Figure> limitsFigure(const OutcomePtr& outcome, const Place& at);

/// The part between its supports with its dimensions, the zones or sections and the gauge.
[[nodiscard]] Figure partSketch(const OutcomePtr& outcome);

} // namespace sparkout::report
