// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of plots: building, linking, labels and colours.
#include "ui/views/feeds_plot.h"

#include "ui/views/band_layer.h"
#include "ui/views/feed_text.h"
#include "ui/views/names.h"
#include "ui/views/plot_style.h"

#include <algorithm>

namespace sparkout {

using style::Hue;

namespace {

/// A name in one line, or in two, or the short one: whatever fits the width.
QString fitted(const QString& full, const QString& brief, const QFontMetrics& metrics, int width) {
    if (metrics.horizontalAdvance(full) <= width) {
        return full;
    }
    const qsizetype middle = full.size() / 2;
    const qsizetype after = full.indexOf(u' ', middle);
    const qsizetype before = full.lastIndexOf(u' ', middle);
    const bool later = after >= 0 && (before < 0 || after - middle < middle - before);
    const qsizetype cut = later ? after : before;
    if (cut < 0) {
        return brief;
    }
    const QString lines = full.left(cut) + u'\n' + full.mid(cut + 1);
    const bool fits = metrics.horizontalAdvance(full.left(cut)) <= width
                      && metrics.horizontalAdvance(full.mid(cut + 1)) <= width;
    return fits ? lines : brief;
}

} // namespace

void FeedsPlot::buildGrid() {
    for (Column& column : m_columns) {
        for (BandLayer* band : column.bands) {
            delete band;
        }
    }
    m_columns.clear();
    clearGraphs();
    plotLayout()->clear();
    plotLayout()->setRowSpacing(2);
    plotLayout()->setColumnSpacing(0);
    m_columns.resize(m_series.columns.size());
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].header = new QCPTextElement(this);
        plotLayout()->addElement(0, static_cast<int>(i), m_columns[i].header);
        for (int row = 0; row < rowCount; ++row) {
            buildCell(m_columns[i], row, static_cast<int>(i));
        }
    }
    plotLayout()->setRowStretchFactor(0, 0.001);
    m_ownValues = {};
    linkAxes();
    restyle();
    retranslate();
}

void FeedsPlot::buildCell(Column& column, int row, int index) {
    auto* rect = new QCPAxisRect(this, true);
    const auto r = static_cast<std::size_t>(row);
    const bool first = index == 0;
    const bool last = index + 1 == static_cast<int>(m_columns.size());
    column.rects[r] = rect;
    plotLayout()->addElement(row + 1, index, rect);
    rect->setRangeDragAxes(rect->axis(QCPAxis::atBottom), nullptr);
    const int top = row == 0 ? BandLayer::nameMargin(font()) : 4;
    rect->setMinimumMargins(
        QMargins(first ? 0 : 10, top, last ? 0 : 10, row + 1 < rowCount ? 4 : 0));
    setUpAxes(rect, row, first, last);
    column.bands[r] = new BandLayer(rect, row == 0);
    addRow(column, row);
}

void FeedsPlot::setUpAxes(QCPAxisRect* rect, int row, bool first, bool last) {
    for (QCPAxis* axis : rect->axes()) {
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->setNumberFormat(QStringLiteral("g"));
        axis->setNumberPrecision(6);
        axis->setSubTicks(false);
        axis->ticker()->setTickCount(4);
    }
    rect->axis(QCPAxis::atTop)->setVisible(true);
    rect->axis(QCPAxis::atTop)->setTicks(false);
    rect->axis(QCPAxis::atTop)->setTickLabels(false);
    rect->axis(QCPAxis::atRight)->setVisible(true);
    rect->axis(QCPAxis::atRight)->setTicks(row == 1);
    rect->axis(QCPAxis::atRight)->setTickLabels(row == 1 && last);
    rect->axis(QCPAxis::atRight)->grid()->setVisible(false);
    rect->axis(QCPAxis::atLeft)->setTickLabels(first);
    rect->axis(QCPAxis::atBottom)->setTickLabels(row + 1 == rowCount);
}

void FeedsPlot::addRow(Column& column, int row) {
    QCPAxisRect* rect = column.rects[static_cast<std::size_t>(row)];
    QCPAxis* left = rect->axis(QCPAxis::atLeft);
    if (row == 0) {
        addCurves(column, Quantity::actual, left, true);
        addCurves(column, Quantity::programmed, left, false);
    } else if (row == 1) {
        addCurves(column, Quantity::came, rect->axis(QCPAxis::atRight), true);
        addCurves(column, Quantity::left, rect->axis(QCPAxis::atRight), true);
        addCurves(column, Quantity::actualSum, left, true);
        addCurves(column, Quantity::programmedSum, left, false);
    } else if (m_series.operation == Operation::traverse) {
        addCurves(column, Quantity::axialFeed, left, false);
    } else {
        addCurves(column, Quantity::force, left, true);
    }
}

void FeedsPlot::addCurves(Column& column, Quantity quantity, QCPAxis* value, bool band) {
    QCPAxis* key = value->axisRect()->axis(QCPAxis::atBottom);
    QCPGraph* low = nullptr;
    for (Edge edge : {Edge::low, Edge::high, Edge::mean}) {
        if (edge != Edge::mean && !band) {
            continue;
        }
        QCPGraph* graph = addGraph(key, value);
        graph->removeFromLegend();
        graph->setSelectable(QCP::stNone);
        if (edge == Edge::low) {
            low = graph;
        } else if (edge == Edge::high) {
            graph->setChannelFillGraph(low);
        }
        column.curves.push_back({quantity, edge, graph});
    }
}

void FeedsPlot::linkAxes() {
    const auto changed = QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged);
    auto* left = new QCPMarginGroup(this);
    auto* right = new QCPMarginGroup(this);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        for (QCPAxisRect* rect : m_columns[i].rects) {
            connect(rect->axis(QCPAxis::atBottom), changed, this, &FeedsPlot::onTimesChanged);
            for (auto type : {QCPAxis::atLeft, QCPAxis::atRight}) {
                QCPAxis* axis = rect->axis(type);
                connect(axis, changed, this,
                        [this, axis](const QCPRange& range) { onValuesChanged(axis, range); });
            }
            if (i == 0) {
                rect->setMarginGroup(QCP::msLeft, left);
            }
            if (i + 1 == m_columns.size()) {
                rect->setMarginGroup(QCP::msRight, right);
            }
        }
    }
}

void FeedsPlot::retranslate() {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(numbers);
    labelAxes();
    fitHeaders();
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        fillBands(i);
    }
}

void FeedsPlot::labelAxes() {
    QString x;
    switch (m_axis) {
    case CycleAxis::minutes: x = tr("Time, min"); break;
    case CycleAxis::seconds: x = tr("Time, s"); break;
    case CycleAxis::strokes:
        x = m_series.operation == Operation::traverse ? tr("Double strokes done")
                                                      : tr("Revolutions done");
        break;
    case CycleAxis::revolutions: x = tr("Revolutions done"); break;
    }
    const bool plunge = m_series.operation == Operation::plunge;
    const QString feed = plunge                       ? tr("Feed, µm\nper revolution")
                         : m_detail == Detail::stroke ? tr("Feed, µm per\ndouble stroke")
                                                      : tr("Feed, µm\nper pass");
    const QString last = plunge ? tr("Normal\nforce, N") : tr("Axial feed,\nmm/min");
    for (Column& column : m_columns) {
        column.rects[2]->axis(QCPAxis::atBottom)->setLabel(x);
        if (&column == &m_columns.front()) {
            column.rects[0]->axis(QCPAxis::atLeft)->setLabel(feed);
            column.rects[1]->axis(QCPAxis::atLeft)->setLabel(tr("Accumulated\nfeed, µm"));
            column.rects[2]->axis(QCPAxis::atLeft)->setLabel(last);
        }
        if (&column == &m_columns.back()) {
            column.rects[1]->axis(QCPAxis::atRight)->setLabel(tr("Radius above\ntarget, µm"));
        }
    }
}

void FeedsPlot::fitHeaders() {
    if (m_columns.empty()) {
        return;
    }
    // Equal plots, though the first and the last column also hold labels.
    const QFontMetrics metrics(font());
    const int side = metrics.height() * 2 + metrics.horizontalAdvance(QStringLiteral("00000")) + 18;
    const auto count = static_cast<int>(m_columns.size());
    const int plot = std::max((width() - 2 * side) / count, 40);
    for (int i = 0; i < count; ++i) {
        const int sides = (i == 0 ? side : 0) + (i + 1 == count ? side : 0);
        plotLayout()->setColumnStretchFactor(i, plot + sides);
        const FeedColumn& zone = m_series.columns[static_cast<std::size_t>(i)];
        QCPTextElement* header = m_columns[static_cast<std::size_t>(i)].header;
        QString full = Names::zoneFull(zone.zone, zone.section);
        if (zone.gauge) {
            full = tr("%1 (gauge)").arg(full);
        }
        const QString brief = Names::zone(zone.zone, zone.section);
        header->setText(fitted(full, brief, metrics, plot - 4));
        // Centred over the plot, not over its labels.
        header->setMargins(QMargins(i == 0 ? side : 0, 2, i + 1 == count ? side : 0, 0));
        header->setFont(font());
        header->setTextColor(palette().color(QPalette::Text));
        for (QCPAxisRect* rect : m_columns[static_cast<std::size_t>(i)].rects) {
            const int room = metrics.horizontalAdvance(QStringLiteral("000000"));
            rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(std::clamp(plot / room, 2, 8));
        }
    }
}

QColor FeedsPlot::colourOf(Quantity quantity) const {
    switch (quantity) {
    case Quantity::programmed:
    case Quantity::programmedSum: return style::colour(Hue::blue, palette());
    case Quantity::actual:
    case Quantity::actualSum: return style::colour(Hue::vermilion, palette());
    case Quantity::came: return style::colour(Hue::green, palette());
    case Quantity::left: return style::colour(Hue::purple, palette());
    case Quantity::axialFeed:
    case Quantity::force: return style::colour(Hue::orange, palette());
    }
    return palette().color(QPalette::Text);
}

QColor FeedsPlot::colourOf(Zone zone, Step step) const {
    constexpr Hue hues[] = {Hue::orange, Hue::sky, Hue::green, Hue::purple, Hue::yellow, Hue::sky};
    QColor colour = style::colour(hues[static_cast<int>(strokeStep(zone, step))], palette());
    colour.setAlpha(style::isDark(palette()) ? 70 : 60);
    return colour;
}

void FeedsPlot::stylePens(Column& column) {
    for (const Curve& c : column.curves) {
        const QColor colour = style::dimmed(colourOf(c.quantity), m_dim);
        if (c.edge != Edge::mean) {
            QColor fill = colour;
            fill.setAlphaF(fill.alphaF() * 0.25F);
            c.graph->setPen(Qt::NoPen);
            c.graph->setBrush(c.edge == Edge::high ? QBrush(fill) : QBrush(Qt::NoBrush));
            continue;
        }
        const bool programmed =
            c.quantity == Quantity::programmed || c.quantity == Quantity::programmedSum;
        const Qt::PenStyle dash = programmed                     ? Qt::DashLine
                                  : c.quantity == Quantity::came ? Qt::DotLine
                                                                 : Qt::SolidLine;
        c.graph->setPen(QPen(colour, 1.5, dash));
    }
}

void FeedsPlot::restyle() {
    style::applyPalette(*this, palette());
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        stylePens(m_columns[i]);
        m_columns[i].header->setTextColor(palette().color(QPalette::Text));
        fillBands(i);
    }
}

std::vector<LegendEntry> FeedsPlot::legendEntries() const {
    std::vector<LegendEntry> entries;
    if (m_columns.empty()) {
        return entries;
    }
    const auto line = [&](Quantity q, Qt::PenStyle pen, const QString& text) {
        entries.push_back({style::dimmed(colourOf(q), m_dim), pen, text});
    };
    line(Quantity::programmed, Qt::DashLine, quantityName(Quantity::programmed));
    line(Quantity::actual, Qt::SolidLine, quantityName(Quantity::actual));
    line(Quantity::came, Qt::DotLine, quantityName(Quantity::came));
    line(Quantity::left, Qt::SolidLine, quantityName(Quantity::left));
    const bool plunge = m_series.operation == Operation::plunge;
    const Quantity last = plunge ? Quantity::force : Quantity::axialFeed;
    line(last, Qt::SolidLine, quantityName(last));
    if (m_detail != Detail::radius) {
        QColor grey = palette().color(QPalette::Text);
        grey.setAlpha(60);
        entries.push_back({grey, Qt::NoPen, tr("smallest…largest over the radii")});
    }
    if (showsSteps()) {
        for (Step step : {Step::e1, Step::e2, Step::e3, Step::e4}) {
            entries.push_back(
                {colourOf(Zone::rz1, step), Qt::NoPen, Names::stepMeaning(Zone::rz1, step)});
        }
        entries.push_back(
            {colourOf(Zone::rz2, Step::e2), Qt::NoPen, Names::stepMeaning(Zone::rz2, Step::e2)});
    }
    return entries;
}

} // namespace sparkout
