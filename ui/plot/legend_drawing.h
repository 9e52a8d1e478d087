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

struct LegendEntry {
    QColor colour;
    Qt::PenStyle pen = Qt::SolidLine; ///< NoPen: a swatch
    QString text;
    int key = -1;                 ///< key that a click hides or shows; negative: none
    bool shown = true;            ///< false: hidden by the user, drawn faintly
    QVector<qreal> dash = {};     ///< dashes of the line, in pen widths; empty: those of `pen`
    QColor halo = {};             ///< outline of the line; none by default
    Swatch swatch = Swatch::area; ///< used without a line
    Hatch hatch = Hatch::none;    ///< pattern over a swatch
    QColor hatchLine = {};        ///< colour of the pattern's lines
    double weight = 2;            ///< width of the line
};
using LegendEntries = std::vector<LegendEntry>;

/// Rectangles of the entries in rows of at most `width`, from (0, 0); a longer text is wrapped.
[[nodiscard]] std::vector<QRect> legendRects(const LegendEntries& entries,
                                             const QFontMetrics& metrics, int width);

/// Total height of the rows.
[[nodiscard]] int legendHeight(const std::vector<QRect>& rects);

void drawLegendEntry(QPainter& painter, const LegendEntry& entry, const QRect& rect,
                     const QColor& textColour);

/// The curves hidden by the user, by the keys of the legend.
class CurveChoice {
public:
    [[nodiscard]] bool shows(int key) const { return !m_hidden.contains(key); }
    void toggle(int key);
    /// Shows only this entry; if it is the only one already, all.
    void only(int key, const LegendEntries& entries);

private:
    std::set<int> m_hidden;
};

} // namespace sparkout
