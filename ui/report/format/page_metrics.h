// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QMarginsF>

namespace sparkout::report {

/// The measures of a page, by its style: type in points, distances in tenths of a point.
struct PageMetrics {
    double body, small, heading, title;
    double cell, cellHead; ///< font sizes of tables
    double formula;
    double lineSpacing;   ///< line spacing of texts, in line heights
    double indent;        ///< indent of a text's first line, and of a heading
    double apart;         ///< distance of tables and figures from their neighbours
    double head, foot;    ///< space for the head and foot of every page
    QMarginsF margins_mm; ///< margins of the paper in addition to that space
};

/// ГОСТ 7.32: 30, 15, 20 and 20 mm of margins, type of 12 points, a line and a half, 12.5 mm of
/// indent.
[[nodiscard]] const PageMetrics& metricsOf(PageStyle style);

} // namespace sparkout::report
