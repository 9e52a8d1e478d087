// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, pens and the legend.
#include "ui/views/feeds/feeds_plot.h"

#include "ui/plot/band_layer.h"
#include "ui/plot/feed_text.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"

namespace sparkout {

QColor FeedsPlot::colourOf(Quantity quantity) const {
    return style::colour(style::drawnAs(quantity), palette());
}

int FeedsPlot::keyOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmedSum: return static_cast<int>(Quantity::programmed);
    case Quantity::actualSum: return static_cast<int>(Quantity::actual);
    default: return static_cast<int>(quantity);
    }
}

QColor FeedsPlot::stepColour(Zone zone, Step step, const QPalette& palette) {
    const auto index = static_cast<std::size_t>(strokeStep(zone, step));
    QColor colour = tone(style::stepOfStroke(index, palette), palette);
    colour.setAlpha(style::isDark(palette) ? 75 : 85);
    return colour;
}

void FeedsPlot::stylePens(Column& column) {
    for (const Curve& c : column.curves) {
        const QColor colour = style::dimmed(colourOf(c.quantity), isDimmed());
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
        c.graph->setPen(QPen(colour, c.quantity == Quantity::force ? 1.2 : 1.5, dash));
    }
}

void FeedsPlot::restyle() {
    style::applyPalette(*this, palette());
    const QColor text = palette().color(QPalette::Text);
    for (Column& column : m_columns) {
        stylePens(column);
        column.header->setTextColor(text);
        for (const QCPAxisRect* rect : column.rects) {
            for (QCPAxis* axis : rect->axes()) {
                axis->setTickLabelFont(font());
                axis->setLabelFont(font());
            }
        }
        QMargins top = column.rects[0]->minimumMargins();
        top.setTop(BandLayer::nameMargin(font()));
        column.rects[0]->setMinimumMargins(top);
    }
    if (m_timeLabel) {
        m_timeLabel->setTextColor(text);
        m_timeLabel->setFont(font());
        fillBands();
    }
}

void FeedsPlot::takeLook(bool) {
    if (m_timeLabel) {
        restyle();
        fitColumns();
    }
}

LegendEntries FeedsPlot::legendEntries() const {
    LegendEntries entries;
    if (m_columns.empty()) {
        return entries;
    }
    const auto line = [&](Quantity q, Qt::PenStyle pen) {
        const int key = keyOf(q);
        entries.push_back({style::dimmed(colourOf(q), isDimmed()), pen, quantityName(q), key,
                           m_choice.shows(key)});
    };
    line(Quantity::programmed, Qt::DashLine);
    line(Quantity::actual, Qt::SolidLine);
    line(Quantity::came, Qt::DotLine);
    line(Quantity::left, Qt::SolidLine);
    if (hasAxialFeed()) {
        line(Quantity::axialFeed, Qt::SolidLine);
    }
    line(Quantity::force, Qt::SolidLine);
    QColor grey = palette().color(QPalette::Text);
    grey.setAlpha(60);
    entries.push_back(
        {grey, Qt::NoPen, tr("spread over the radii"), spreadKey, m_choice.shows(spreadKey)});
    for (const auto& [zone, step] : m_steps) {
        entries.push_back(
            {stepColour(zone, step, palette()), Qt::NoPen, Names::stepMeaning(zone, step)});
    }
    return entries;
}

} // namespace sparkout
