// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

/// A plot's one cell with the part's length over its axis of rotation: radii from the target in
/// micrometres, far above the axis, which stands in a strip below the cell behind a break line.
namespace sparkout {

inline constexpr int partAxisHeight = 20; ///< of the strip [px]

/// The plot's only cell, with a layer "bands" below the grid.
[[nodiscard]] QCPAxisRect* addPartCell(QCustomPlot& plot);
void stylePartCell(QCPAxisRect& cell); ///< palette, fonts and margins
void namePartCell(QCPAxisRect& cell);  ///< axes, in the present language
void drawPartAxis(QCPPainter& painter, const QCPAxisRect& cell);

} // namespace sparkout
