// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/hatch.h"

#include <QColor>
#include <QFontMetrics>
#include <QRect>
#include <QString>
#include <QVector>

#include <set>
#include <vector>

class QPainter;

namespace sparkout {

enum class Swatch { area, square, rhombus }; ///< filled, or the mark of a point

/// One entry of a legend: a line sample or a filled swatch, and its text.
struct LegendEntry {
    QColor colour;
    Qt::PenStyle pen = Qt::SolidLine; ///< NoPen: a swatch
    QString text;
    int key = -1;                 ///< what a click hides or shows; below 0: nothing
    bool shown = true;            ///< false: hidden by the user, drawn faintly
    QVector<qreal> dash = {};     ///< of the line, in widths of the pen; empty: as `pen` says
    QColor halo = {};             ///< around the line; none: nothing
    Swatch swatch = Swatch::area; ///< where there is no line
    Hatch hatch = Hatch::none;    ///< over a swatch …
    QColor hatchLine = {};        ///< … and its lines
    double weight = 2;            ///< of the line
};
using LegendEntries = std::vector<LegendEntry>;

/// Places of the entries in rows of at most `width`, from (0, 0); a longer text takes several
/// lines.
[[nodiscard]] std::vector<QRect> legendRects(const LegendEntries& entries,
                                             const QFontMetrics& metrics, int width);

/// Height of the lines together.
[[nodiscard]] int legendHeight(const std::vector<QRect>& rects);

void drawLegendEntry(QPainter& painter, const LegendEntry& entry, const QRect& rect,
                     const QColor& textColour);

/// Which curves the user hid, by the keys of the legend.
class CurveChoice {
public:
    [[nodiscard]] bool shows(int key) const { return !m_hidden.contains(key); }
    void toggle(int key);
    /// Shows only this one of the entries; asked again, all.
    void only(int key, const LegendEntries& entries);

private:
    std::set<int> m_hidden;
};

} // namespace sparkout
