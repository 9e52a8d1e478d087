// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/capability_chart.h"

#include "ui/report/format/plot_figure.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/number_text.h"
#include "ui/views/batch/batch_text.h"

#include <QPainter>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr std::size_t mostCharted = 24; ///< rows
constexpr double customaryPpk = 1.33;
// Colours on paper.
constexpr QColor chartInk(0, 0, 0), chartMark(40, 40, 40), chartGrid(190, 190, 190),
    chartGood(20, 90, 160), chartPoor(190, 60, 20);

} // namespace

CapabilityChart::CapabilityChart(std::vector<CharacteristicSummary> rows)
    : m_rows(std::move(rows)) {
    for (const CharacteristicSummary& of : m_rows) {
        m_lowest = of.ppk->interval.low < 0 ? -1 : m_lowest;
    }
    for (const double end : {2.0, 3.0, 5.0, 10.0}) {
        m_highest = end;
        if (end >= 1.2 * m_rows.front().ppk->interval.high) {
            break;
        }
    }
}

QSizeF CapabilityChart::size() const {
    return {double(figureWidth), top + rowHeight * double(m_rows.size()) + bottom};
}

void CapabilityChart::paint(QPainter& painter) const {
    QFont font;
    font.setPixelSize(fontPixels);
    painter.setFont(font);
    paintScale(painter);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        paintRow(painter, m_rows[i], top + rowHeight * (double(i) + 0.5));
    }
}

double CapabilityChart::x(double ppk) const {
    return left
           + (right - left) * (std::clamp(ppk, m_lowest, m_highest) - m_lowest)
                 / (m_highest - m_lowest);
}

void CapabilityChart::paintScale(QPainter& painter) const {
    const double end = top + rowHeight * double(m_rows.size());
    std::vector<QRectF> taken; // the marks' numbers have priority over the others
    for (const double value : {1.0, customaryPpk, 0.0, 10.0, 5.0, 3.0, 2.0, -1.0}) {
        if (value < m_lowest || value > m_highest) {
            continue;
        }
        const bool mark = value == customaryPpk || value == 1;
        painter.setPen(QPen(mark ? chartMark : chartGrid, 1, mark ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(QPointF(x(value), top), QPointF(x(value), end));
        const QString name = printedNumber(value);
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(name);
        constexpr double reach = 3; // the two marks are close: keep their numbers apart
        const double from = value == 1              ? x(value) + reach - width
                            : value == customaryPpk ? x(value) - reach
                                                    : x(value) - width / 2;
        const QRectF box(from - reach, end, width + 2 * reach, bottom);
        const auto meets = [&box](const QRectF& other) { return box.intersects(other); };
        if (mark || std::ranges::none_of(taken, meets)) {
            painter.setPen(chartInk);
            painter.drawText(QPointF(from, end + 16), name);
            taken.push_back(box);
        }
    }
}

void CapabilityChart::paintRow(QPainter& painter, const CharacteristicSummary& of, double y) const {
    const Estimate& ppk = *of.ppk;
    const QFontMetricsF metrics(painter.font());
    const double base = y + metrics.ascent() / 2 - 1;
    painter.setPen(chartInk);
    painter.drawText(QPointF(2, base), metrics.elidedText(BatchText::full(of.characteristic),
                                                          Qt::ElideRight, left - 12));
    painter.drawText(QPointF(right + 10, base), BatchText::capability(of.ppk));
    const QColor colour = ppk.value < 1 ? chartPoor : chartGood;
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QPointF(x(ppk.interval.low), y), QPointF(x(ppk.interval.high), y));
    painter.setBrush(colour);
    if (ppk.value <= m_highest) {
        painter.drawEllipse(QPointF(x(ppk.value), y), 4, 4);
    } else { // outside the scale
        painter.drawPolygon(
            QPolygonF{QPointF(right - 7, y - 5), QPointF(right + 1, y), QPointF(right - 7, y + 5)});
    }
}

std::optional<Figure> CapabilityChart::figure(const BatchSummary& summary) {
    std::vector<CharacteristicSummary> rows;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.ppk) {
            rows.push_back(of);
        }
    }
    if (rows.empty()) {
        return {};
    }
    std::ranges::stable_sort(rows, {}, [](const auto& of) { return of.ppk->value; });
    rows.resize(std::min(rows.size(), mostCharted));
    QStringList values;
    for (const CharacteristicSummary& of : rows) {
        values << QStringLiteral("%1: %2").arg(BatchText::full(of.characteristic),
                                               BatchText::capability(of.ppk));
    }
    const CapabilityChart chart(std::move(rows));
    return Figure{tr("Ppk with its 95 % bounds, the smallest first; dashed: 1 and %1")
                      .arg(printedNumber(customaryPpk)),
                  values.join(QStringLiteral("; ")), chart.size(),
                  [chart](QPainter& painter) { chart.paint(painter); }};
}

} // namespace sparkout::report
