// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/legend_drawing.h"

#include <QPainter>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int sample = 22;
constexpr int sampleGap = 5;
constexpr int between = 14;
constexpr int swatchHeight = 10;
constexpr int haloWidth = 4;
constexpr double hiddenOpacity = 0.45; ///< opacity of hidden entries

int textWidth(const QString& text, const QFontMetrics& metrics) {
    return metrics.horizontalAdvance(text) + 2;
}

/// The size of a text broken between words into lines of at most `width`.
QSize wrappedSize(const QString& text, const QFontMetrics& metrics, int width) {
    constexpr int unlimited = 100'000;
    return metrics.boundingRect(QRect(0, 0, width, unlimited), Qt::TextWordWrap, text).size();
}

} // namespace

std::vector<QRect> legendRects(const LegendEntries& entries, const QFontMetrics& metrics,
                               int width) {
    std::vector<QRect> rects;
    const int line = metrics.height() + 2;
    int x = 0, y = 0, below = line;
    for (const LegendEntry& e : entries) {
        const int full = sample + sampleGap + textWidth(e.text, metrics);
        const int w = std::min(full, width);
        if (x > 0 && x + w > width) {
            x = 0;
            y += below;
            below = line;
        }
        if (full > width) { // alone in its row
            below = std::max(line,
                             wrappedSize(e.text, metrics, width - sample - sampleGap).height() + 2);
        }
        rects.emplace_back(x, y, w, below);
        x += w + between;
    }
    return rects;
}

int legendHeight(const std::vector<QRect>& rects) {
    return rects.empty() ? 0 : rects.back().bottom() + 1;
}

namespace {

void drawSwatch(QPainter& painter, const LegendEntry& entry, const QRectF& swatch) {
    if (entry.swatch == Swatch::area) {
        painter.fillRect(swatch, entry.colour);
        paintHatch(painter, swatch.toRect(), entry.hatch, entry.hatchLine);
        return;
    }
    const QPointF at = swatch.center();
    const double reach = swatch.height() / 2;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(entry.colour, 2));
    painter.setBrush(Qt::NoBrush);
    if (entry.swatch == Swatch::square) {
        painter.drawRect(QRectF(at.x() - reach, at.y() - reach, 2 * reach, 2 * reach));
    } else {
        painter.drawPolygon(QPolygonF({at + QPointF(0, -reach), at + QPointF(reach, 0),
                                       at + QPointF(0, reach), at + QPointF(-reach, 0)}));
    }
}

} // namespace

void drawLegendEntry(QPainter& painter, const LegendEntry& entry, const QRect& rect,
                     const QColor& textColour) {
    painter.save();
    painter.setOpacity(entry.shown ? 1 : hiddenOpacity);
    const int middle = rect.top() + (QFontMetrics(painter.font()).height() + 1) / 2;
    if (entry.pen == Qt::NoPen) {
        const QRect swatch(rect.left() + 4, middle - swatchHeight / 2 + 1, sample - 8,
                           swatchHeight);
        drawSwatch(painter, entry, swatch);
    } else {
        QPen pen(entry.colour, entry.weight, entry.pen, Qt::FlatCap);
        if (!entry.dash.isEmpty()) {
            pen.setDashPattern(entry.dash);
        }
        if (entry.halo.isValid()) {
            painter.setPen(QPen(entry.halo, haloWidth, Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(rect.left(), middle, rect.left() + sample, middle);
        }
        painter.setPen(pen);
        painter.drawLine(rect.left(), middle, rect.left() + sample, middle);
    }
    painter.setPen(textColour);
    QFont font = painter.font();
    font.setStrikeOut(!entry.shown);
    painter.setFont(font);
    const QRect text = rect.adjusted(sample + sampleGap, 0, 0, 0);
    const QFontMetrics metrics(font);
    const int align = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip;
    const bool wraps = textWidth(entry.text, metrics) > text.width()
                       && wrappedSize(entry.text, metrics, text.width()).width() <= text.width();
    painter.drawText(text, wraps ? align | Qt::TextWordWrap : align,
                     wraps ? entry.text
                           : metrics.elidedText(entry.text, Qt::ElideRight, text.width()));
    painter.restore();
}

void CurveChoice::toggle(int key) {
    if (m_hidden.erase(key) == 0) {
        m_hidden.insert(key);
    }
}

void CurveChoice::only(int key, const LegendEntries& entries) {
    std::set<int> others;
    for (const LegendEntry& e : entries) {
        if (e.key >= 0 && e.key != key) {
            others.insert(e.key);
        }
    }
    m_hidden = m_hidden == others ? std::set<int>() : others;
}

} // namespace sparkout
