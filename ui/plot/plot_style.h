// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/text/number_text.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QPalette>

#include <qcustomplot.h>

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

namespace sparkout {

/// The numbers of an axis with a typographic minus; very small and large ones with a power of ten.
class NumberTicker : public QCPAxisTicker {
protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        const QString label =
            withPower(QCPAxisTicker::getTickLabel(tick, locale, format, precision));
        return label.startsWith(u'-') ? u'−' + label.mid(1) : label;
    }
};

/// Only whole numbers, for counts.
class WholeTicker : public QCPAxisTickerFixed {
public:
    WholeTicker() {
        setTickStep(1);
        setScaleStrategy(ssMultiples);
    }
};

} // namespace sparkout
