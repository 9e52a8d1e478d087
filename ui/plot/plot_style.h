// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QList>
#include <QPalette>

class QCPAxis;
class QCPAxisRect;
class QCustomPlot;

/// Axes and safe ranges that the plots share; text and lines of the axes follow the palette.
namespace sparkout::style {

[[nodiscard]] bool isDark(const QPalette& palette);

[[nodiscard]] QColor dimmed(QColor colour, bool dim); ///< mostly transparent when dim

[[nodiscard]] QColor thinned(QColor colour, int alpha); ///< of this opacity, to 255
/// Of an area behind the curves; stronger in the contrast theme, which has no other colour there.
[[nodiscard]] QColor filling(QColor colour, int alpha, const QPalette& palette);

/// All axes, side by side. QCustomPlot's own order of them is another at each start of the program,
/// and what is drawn in it with it.
[[nodiscard]] QList<QCPAxis*> axesOf(const QCPAxisRect& rect);

void applyPalette(QCustomPlot& plot, const QPalette& palette);
void applyPalette(QCPAxis& axis, const QPalette& palette);
void setUpAxis(QCPAxis& axis); ///< its layers, and plain numbers (NumberTicker)
void setLogarithmic(QCPAxis& axis, bool on);

/// The names of the value axes in that type, or in smaller, to a limit, as a low plot asks for; and
/// no more numbers than have room. True where that is drawn with the next replot.
bool fitValueAxes(QCPAxisRect& rect, const QFont& font);
/// So many numbers of that type stand one above the other, at most the usual number.
[[nodiscard]] int ticksWithRoom(int height, const QFont& font);

/// Sets a range QCustomPlot can draw: finite, growing, not narrower than rounding allows. Other
/// ranges are ignored.
void setSafeRange(QCPAxis& axis, double low, double high);

/// The same with room beside both ends: a share of the range, and of the values themselves at
/// least.
void setRoomyRange(QCPAxis& axis, double low, double high, double room, double leastRoom);

} // namespace sparkout::style
