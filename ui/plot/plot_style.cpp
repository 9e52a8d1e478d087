// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_style.h"

#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <cmath>

namespace sparkout::style {

bool isDark(const QPalette& palette) {
    return sparkout::isDark(palette);
}

QColor dimmed(QColor colour, bool dim) {
    if (dim) {
        colour.setAlphaF(colour.alphaF() * 0.35F);
    }
    return colour;
}

QColor thinned(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

QColor filling(QColor colour, int alpha, const QPalette& palette) {
    const bool isContrast = coloursFor(palette).theme == Theme::contrast;
    return thinned(colour, isContrast ? 8 * alpha / 5 : alpha); // more would hide the curves
}

void setUpAxis(QCPAxis& axis) {
    axis.setLayer(QStringLiteral("axes"));
    axis.grid()->setLayer(QStringLiteral("grid"));
    axis.setNumberFormat(QStringLiteral("g"));
    axis.setNumberPrecision(6);
    axis.setSubTicks(false);
    axis.setTicker(QSharedPointer<NumberTicker>::create());
}

void setLogarithmic(QCPAxis& axis, bool on) {
    axis.setScaleType(on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis.setTicker(on ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                      : QSharedPointer<QCPAxisTicker>(new NumberTicker));
}

void applyPalette(QCPAxis& axis, const QPalette& palette) {
    const QColor text = palette.color(QPalette::Text);
    const QColor line = thinned(text, 150);
    axis.setBasePen(line);
    axis.setTickPen(line);
    axis.setSubTickPen(line);
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    const QColor grid = thinned(text, 35);
    axis.grid()->setPen(QPen(grid, 0));
    axis.grid()->setSubGridVisible(false);
    axis.grid()->setZeroLinePen(QPen(line, 0));
}

QList<QCPAxis*> axesOf(const QCPAxisRect& rect) {
    return rect.axes(QCPAxis::atLeft | QCPAxis::atRight | QCPAxis::atTop | QCPAxis::atBottom);
}

void applyPalette(QCustomPlot& plot, const QPalette& palette) {
    plot.setBackground(palette.brush(QPalette::Base));
    for (QCPAxisRect* rect : plot.axisRects()) {
        for (QCPAxis* axis : axesOf(*rect)) {
            applyPalette(*axis, palette);
        }
    }
}

int ticksWithRoom(int height, const QFont& font) {
    constexpr int least = 2, usual = 5;
    constexpr double lines = 1.4; // height of a tick label with spacing, in lines
    return std::clamp(static_cast<int>(height / (lines * QFontMetrics(font).height())), least,
                      usual);
}

bool fitValueAxes(QCPAxisRect& rect, const QFont& font) {
    constexpr double least = 0.6; // least share of the usual size
    constexpr int air = 6;        // space beyond the plot, before a neighbour's label
    bool changed = false;
    const auto fit = [&](QCPAxis& axis, int room) {
        int need = 1;
        for (const QString& line : axis.label().split(u'\n')) {
            need = std::max(need, QFontMetrics(font).horizontalAdvance(line));
        }
        const double times = double(room) / need;
        const QFont own = times < 1 ? enlarged(font, std::max(times, least)) : font;
        if (axis.labelFont() != own) {
            axis.setLabelFont(own);
            changed = true;
        }
    };
    const QRect all = rect.outerRect(); // a label is centred on its axis
    const int centre = rect.center().x();
    for (QCPAxis* axis : rect.axes(QCPAxis::atBottom)) {
        fit(*axis, 2 * std::min(centre - all.left(), all.right() - centre) - air);
    }
    for (QCPAxis* axis : rect.axes(QCPAxis::atLeft | QCPAxis::atRight)) {
        fit(*axis, rect.height() + air);
        const int count = ticksWithRoom(rect.height(), font);
        changed = changed || axis->ticker()->tickCount() != count;
        axis->ticker()->setTickCount(count);
    }
    return changed;
}

void setSafeRange(QCPAxis& axis, double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high) || low > high) {
        return;
    }
    const double least = std::max({std::abs(low), std::abs(high), 1e-6}) * 1e-9;
    if (high - low < least) {
        low -= least;
        high += least;
    }
    axis.setRange(low, high);
}

void setRoomyRange(QCPAxis& axis, double low, double high, double room, double leastRoom) {
    const double least = std::max({std::abs(low), std::abs(high), 1e-3}) * leastRoom;
    const double beside = std::max(room * (high - low), least);
    setSafeRange(axis, low - beside, high + beside);
}

} // namespace sparkout::style
