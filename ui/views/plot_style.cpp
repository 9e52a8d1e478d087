// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/plot_style.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace sparkout::style {

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Base).lightness() < 128;
}

QColor colour(Hue hue, const QPalette& palette) {
    const bool dark = isDark(palette);
    switch (hue) {
    case Hue::blue: return dark ? QColor(0x56B4E9) : QColor(0x0072B2);
    case Hue::sky: return QColor(0x56B4E9);
    case Hue::vermilion: return dark ? QColor(0xFF7F3A) : QColor(0xD55E00);
    case Hue::orange: return dark ? QColor(0xE69F00) : QColor(0xB87F00);
    case Hue::green: return dark ? QColor(0x2CC89B) : QColor(0x009E73);
    case Hue::purple: return dark ? QColor(0xE39AC6) : QColor(0xB4578C);
    case Hue::yellow: return QColor(0xF0E442);
    }
    return palette.color(QPalette::Text);
}

QColor dimmed(QColor colour, bool dim) {
    if (dim) {
        colour.setAlphaF(colour.alphaF() * 0.35F);
    }
    return colour;
}

void applyPalette(QCPAxis& axis, const QPalette& palette) {
    const QColor text = palette.color(QPalette::Text);
    QColor line = text;
    line.setAlpha(150);
    axis.setBasePen(line);
    axis.setTickPen(line);
    axis.setSubTickPen(line);
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    QColor grid = text;
    grid.setAlpha(35);
    axis.grid()->setPen(QPen(grid, 0));
    axis.grid()->setSubGridVisible(false);
    axis.grid()->setZeroLinePen(QPen(line, 0));
}

void applyPalette(QCustomPlot& plot, const QPalette& palette) {
    plot.setBackground(palette.brush(QPalette::Base));
    for (QCPAxisRect* rect : plot.axisRects()) {
        for (QCPAxis* axis : rect->axes()) {
            applyPalette(*axis, palette);
        }
    }
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

} // namespace sparkout::style
