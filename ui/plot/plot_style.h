// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QList>
#include <QPalette>

class QCPAxis;
class QCPAxisRect;
class QCustomPlot;

/// Shared axes and safe ranges of the plots; texts and lines of the axes follow the palette.
namespace sparkout::style {

[[nodiscard]] bool isDark(const QPalette& palette);

[[nodiscard]] QColor dimmed(QColor colour, bool dim); ///< mostly transparent when dim

[[nodiscard]] QColor thinned(QColor colour, int alpha); ///< with this opacity, up to 255
/// The colour of an area behind the curves; stronger in the contrast theme, which has no other
/// colour there.
[[nodiscard]] QColor filling(QColor colour, int alpha, const QPalette& palette);

/// All axes, side by side. QCustomPlot's own order, and so that of drawing, changes with each start
/// of the program.
[[nodiscard]] QList<QCPAxis*> axesOf(const QCPAxisRect& rect);

void applyPalette(QCustomPlot& plot, const QPalette& palette);
void applyPalette(QCPAxis& axis, const QPalette& palette);
void setUpAxis(QCPAxis& axis); ///< sets its layers and plain numbers (NumberTicker)
void setLogarithmic(QCPAxis& axis, bool on);

/// Shrinks the names of the value axes down to a limit, and reduces the number of ticks, so that
/// they fit a low plot. True if the next replot shows a change.
bool fitValueAxes(QCPAxisRect& rect, const QFont& font);
/// The number of tick labels in that font that fit the height, at most the usual number.
[[nodiscard]] int ticksWithRoom(int height, const QFont& font);

/// Sets a range QCustomPlot can draw: finite, growing, not narrower than rounding allows. Other
/// ranges are ignored.
void setSafeRange(QCPAxis& axis, double low, double high);

/// Sets a range with a margin at both ends: the share `room` of the range, at least the share
/// `leastRoom` of the values.
void setRoomyRange(QCPAxis& axis, double low, double high, double room, double leastRoom);

} // namespace sparkout::style
