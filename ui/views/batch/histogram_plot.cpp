// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/histogram_plot.h"

#include "ui/plot/number_ticker.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

constexpr double barRoom = 0.05; ///< room beside the outermost bar or limit, relative to the range
constexpr QSize legibleCell(120, 80); ///< least size
constexpr int cellGap = 8;            ///< space beside a cell, for half the number at its corner
constexpr double countRoom = 1.08;    ///< room above the highest bar
constexpr double leastOutlined = 6;   ///< width of a bar with an outline [px]
constexpr int valueTicks = 3;         ///< ticks below narrow cells
constexpr double tickRoom = 1.6;      ///< width of a tick label with spacing, relative to the text
constexpr std::size_t mostNamed = 4;  ///< greatest number of adjacent cells with axis names

} // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeAll);
    connect(this, &QCustomPlot::afterLayout, this, &HistogramPlot::outline);
    built();
}

void HistogramPlot::setSummaries(std::vector<CharacteristicSummary> summaries) {
    const bool sameOne = !m_cells.empty() && summaries.size() == m_cells.size()
                         && std::string_view(summaries.front().characteristic.name)
                                == m_cells.front().summary.characteristic.name;
    const bool moved = sameOne && valueAxis(0)->range() != m_fitted;
    const QCPRange values = moved ? valueAxis(0)->range() : QCPRange();
    const QCPRange counts = moved ? countAxis(0)->range() : QCPRange();
    clearItems();
    clearPlottables();
    plotLayout()->clear();
    m_cells.clear();
    std::vector<QCPAxisRect*> rects;
    for (CharacteristicSummary& summary : summaries) {
        Cell cell;
        cell.summary = std::move(summary);
        build(cell, static_cast<int>(m_cells.size()));
        rects.push_back(cell.rect);
        m_cells.push_back(std::move(cell));
    }
    tie(rects, QCPAxis::atBottom);
    tie(rects, QCPAxis::atLeft);
    if (!m_cells.empty()) {
        QMargins last = rects.back()->minimumMargins();
        last.setRight(2 * cellGap);
        rects.back()->setMinimumMargins(last);
        plotLayout()->setRowStretchFactor(0, 0.001);
        plotLayout()->setRowSpacing(0);
    }
    contentSet();
    if (moved) {
        valueAxis(0)->setRange(values);
        countAxis(0)->setRange(counts);
    }
}

void HistogramPlot::build(Cell& cell, int column) {
    cell.header = new QCPTextElement(this);
    plotLayout()->addElement(0, column, cell.header);
    cell.rect = addRect(1, column);
    cell.rect->setMinimumSize(legibleCell);
    cell.rect->setMinimumMargins(QMargins(column == 0 ? 0 : cellGap, cellGap, cellGap, 0));
    cell.rect->axis(QCPAxis::atLeft)->setTicker(QSharedPointer<WholeTicker>::create());
    cell.rect->axis(QCPAxis::atLeft)->setTickLabels(column == 0); // all have the same range
    QCPAxis* values = cell.rect->axis(QCPAxis::atBottom);
    values->grid()->setVisible(false);
    values->ticker()->setTickCount(valueTicks);
    cell.bars = new QCPBars(values, cell.rect->axis(QCPAxis::atLeft));
    QVector<double> at, counts;
    for (const HistogramBar& bar : cell.summary.histogram) {
        cell.bars->setWidth(bar.high - bar.low);
        if (bar.count > 0) { // an empty bar would still have an outline
            at << (bar.low + bar.high) / 2;
            counts << static_cast<double>(bar.count);
        }
    }
    cell.bars->setData(at, counts, true);
    const Characteristic& of = cell.summary.characteristic;
    cell.low = of.low ? addRule(*cell.rect, *of.low) : nullptr;
    cell.high = of.high ? addRule(*cell.rect, *of.high) : nullptr;
    cell.mean = cell.summary.mean95 ? addRule(*cell.rect, cell.summary.moments.mean) : nullptr;
    setKeyed(partsKey, {cell.bars});
    setKeyed(limitsKey, {cell.low, cell.high});
    setKeyed(meanKey, {cell.mean});
}

void HistogramPlot::fit() {
    double low = std::numeric_limits<double>::max(), high = -low, most = 1;
    for (const Cell& cell : m_cells) {
        for (const HistogramBar& bar : cell.summary.histogram) {
            low = std::min(low, bar.low);
            high = std::max(high, bar.high);
            most = std::max(most, static_cast<double>(bar.count));
        }
        const Characteristic& of = cell.summary.characteristic;
        low = std::min(low, of.low.value_or(low));
        high = std::max(high, of.high.value_or(high));
    }
    if (m_cells.empty() || low > high) {
        return;
    }
    const double beside = barRoom * (high - low);
    style::setSafeRange(*valueAxis(0), low - beside, high + beside);
    style::setSafeRange(*countAxis(0), 0, countRoom * most);
    m_fitted = valueAxis(0)->range();
}

// --- what is shown ------------------------------------------------------------------------------

LegendEntries HistogramPlot::legendEntries() const {
    if (m_cells.empty()) {
        return {};
    }
    const Cell& cell = m_cells.front();
    LegendEntries entries{areaEntry(partsKey, cell.bars->brush().color(), tr("parts"))};
    const auto add = [&](const QCPItemStraightLine* line, Key key, const QString& text) {
        if (line) {
            entries.push_back(lineEntry(key, line->pen(), text));
        }
    };
    add(cell.low ? cell.low : cell.high, limitsKey, tr("drawing limits"));
    add(cell.mean, meanKey, tr("mean"));
    return entries;
}

CsvTable HistogramPlot::table() const {
    CsvTable table;
    table.byPlace = true;
    table.header << tr("Where") << tr("From") << tr("To") << tr("Unit") << tr("Parts");
    for (std::size_t i = 0; i < m_cells.size() && shows(partsKey); ++i) {
        const Characteristic& of = m_cells[i].summary.characteristic;
        const QCPRange range = valueAxis(static_cast<int>(i))->range();
        for (const HistogramBar& bar : m_cells[i].summary.histogram) {
            if (bar.high >= range.lower && bar.low <= range.upper) {
                table.rows.push_back({BatchText::where(of), bar.low, bar.high, unitText(of.unit),
                                      static_cast<double>(bar.count)});
            }
        }
    }
    return table;
}

CsvTable HistogramPlot::tableOf(const BatchSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << tr("Where") << tr("Characteristic") << tr("From") << tr("To") << tr("Unit")
                 << tr("Parts");
    for (const CharacteristicSummary& each : summary.characteristics) {
        const Characteristic& of = each.characteristic;
        for (const HistogramBar& bar : each.histogram) {
            table.rows.push_back({BatchText::where(of), BatchText::name(of), bar.low, bar.high,
                                  unitText(of.unit), static_cast<double>(bar.count)});
        }
    }
    return table;
}

QString HistogramPlot::valuesAt(const QPointF& at) const {
    for (const Cell& cell : m_cells) {
        if (!cell.rect->rect().contains(at.toPoint())) {
            continue;
        }
        const double x = cell.rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
        const Characteristic& of = cell.summary.characteristic;
        for (const HistogramBar& bar : cell.summary.histogram) {
            if (x >= bar.low && x < bar.high) {
                return tr("%1: %2 %3, %n part(s)", nullptr, static_cast<int>(bar.count))
                    .arg(BatchText::full(of),
                         BatchText::mark(bar.low, of) + u'…' + BatchText::mark(bar.high, of),
                         unitText(of.unit));
            }
        }
    }
    return {};
}

// --- look and words -----------------------------------------------------------------------------

void HistogramPlot::restyle() {
    ViewPlot::restyle();
    for (const Cell& cell : m_cells) {
        cell.header->setFont(font());
        cell.header->setTextColor(palette().color(QPalette::Text));
        cell.bars->setBrush(toned(style::Drawn::frequency));
        for (QCPItemStraightLine* limit : {cell.low, cell.high}) {
            if (limit) {
                limit->setPen(QPen(toned(style::Drawn::limit), 2));
            }
        }
        if (cell.mean) {
            cell.mean->setPen(QPen(toned(style::Drawn::mean), 1.5, Qt::DashLine));
        }
    }
}

/// Gives all cells the same width, although the first one also has the numbers on the left; returns
/// whether the layout has changed.
bool HistogramPlot::shareWidth() {
    double room = 0;
    for (const Cell& cell : m_cells) {
        room += cell.rect->width() / static_cast<double>(m_cells.size());
    }
    const bool alike = std::ranges::all_of(
        m_cells, [room](const Cell& cell) { return std::abs(cell.rect->width() - room) <= 1; });
    for (std::size_t i = 0; i < m_cells.size() && !alike; ++i) {
        const QMargins around = m_cells[i].rect->margins();
        plotLayout()->setColumnStretchFactor(static_cast<int>(i),
                                             std::max(room, 1.0) + around.left() + around.right());
    }
    return !alike;
}

/// Whether all axes show their names; otherwise they show the unit, since the box above has the
/// name.
bool HistogramPlot::hasRoomForNames() const {
    const QFontMetrics text(font());
    return m_cells.size() <= mostNamed && std::ranges::all_of(m_cells, [&text](const Cell& cell) {
               return text.horizontalAdvance(BatchText::axis(cell.summary.characteristic))
                      <= cell.rect->width();
           });
}

/// Adapts names, ticks and bars to the width of the cells: a name without room is replaced by the
/// unit, and the ticks become fewer. Bars are separated if enough of them is left; narrow ones form
/// an area of one colour, each at least a pixel wide.
void HistogramPlot::outline() {
    const QFontMetrics text(font());
    bool changed = shareWidth();
    const bool named = hasRoomForNames();
    for (const Cell& cell : m_cells) {
        QCPAxis& values = *cell.rect->axis(QCPAxis::atBottom);
        const Characteristic& of = cell.summary.characteristic;
        values.setLabel(named ? BatchText::axis(of) : unitText(of.unit));
        const int tick =
            std::max(text.horizontalAdvance(BatchText::mark(values.range().lower, of)),
                     text.horizontalAdvance(BatchText::mark(values.range().upper, of)));
        const int ticks =
            std::clamp(static_cast<int>(cell.rect->width() / (tickRoom * tick)), 2, valueTicks);
        changed = changed || values.ticker()->tickCount() != ticks;
        values.ticker()->setTickCount(ticks);
        changed = style::fitValueAxes(*cell.rect, font()) || changed;
        const double width = cell.bars->width() / values.range().size() * cell.rect->width();
        cell.bars->setPen(QPen(width < leastOutlined ? cell.bars->brush().color()
                                                     : palette().color(QPalette::Base),
                               1));
    }
    if (changed) {
        replot(rpQueuedReplot);
    }
}

QString HistogramPlot::headingOf(const CharacteristicSummary& summary) const {
    const Characteristic& of = summary.characteristic;
    const QString where = BatchText::where(of);
    const bool named = m_tellsIndices && summary.ppk && m_cells.size() <= mostNamed;
    const QString ppk = named ? BatchText::brief(*summary.ppk) : QString();
    return !named ? where
           : m_namesIndices
               ? tr("%1, %2: Ppk %3").arg(where, Names::inSentence(BatchText::name(of)), ppk)
               : QStringLiteral("%1, Ppk %2").arg(where, ppk);
}

void HistogramPlot::setTexts() {
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Cell& cell = m_cells[i];
        const Characteristic& of = cell.summary.characteristic;
        cell.header->setText(headingOf(cell.summary));
        cell.rect->axis(QCPAxis::atBottom)
            ->setLabel(m_cells.size() <= mostNamed ? BatchText::axis(of) : unitText(of.unit));
        cell.rect->axis(QCPAxis::atLeft)->setLabel(i == 0 ? tr("Parts") : QString());
    }
}

} // namespace sparkout
