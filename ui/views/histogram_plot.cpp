// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/histogram_plot.h"

#include "core/quality/constraints.h"
#include "ui/session/texts.h"
#include "ui/views/names.h"
#include "ui/views/plot_style.h"

#include <QEvent>
#include <QLocale>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

constexpr double room = 0.05;      ///< beside the outermost bar or limit, of what is between them
constexpr double countRoom = 1.08; ///< above the highest bar

} // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QCustomPlot(parent) {
    setNotAntialiasedElements(QCP::aeAll);
    plotLayout()->clear();
    retranslate();
}

void HistogramPlot::setSummaries(std::vector<CharacteristicSummary> summaries) {
    clearItems();
    clearPlottables();
    plotLayout()->clear();
    m_cells.clear();
    for (CharacteristicSummary& summary : summaries) {
        Cell cell;
        cell.summary = std::move(summary);
        build(cell, static_cast<int>(m_cells.size()));
        m_cells.push_back(std::move(cell));
    }
    if (!m_cells.empty()) {
        plotLayout()->setRowStretchFactor(0, 0.001);
        plotLayout()->setRowSpacing(0);
    }
    restyle();
    retranslate();
    fit();
}

void HistogramPlot::build(Cell& cell, int column) {
    cell.header = new QCPTextElement(this);
    cell.rect = new QCPAxisRect(this, true);
    plotLayout()->addElement(0, column, cell.header);
    plotLayout()->addElement(1, column, cell.rect);
    for (QCPAxis* axis : cell.rect->axes()) {
        style::setUpAxis(*axis);
        connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                [this, axis] { link(axis); });
    }
    QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed); // half a part is none
    whole->setTickStep(1);
    whole->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    cell.rect->axis(QCPAxis::atLeft)->setTicker(whole);
    QCPAxis* values = cell.rect->axis(QCPAxis::atBottom);
    values->grid()->setVisible(false);
    cell.bars = new QCPBars(values, cell.rect->axis(QCPAxis::atLeft));
    cell.bars->removeFromLegend();
    cell.bars->setSelectable(QCP::stNone);
    QVector<double> at, counts;
    for (const HistogramBar& bar : cell.summary.histogram) {
        at << (bar.low + bar.high) / 2;
        counts << static_cast<double>(bar.count);
        cell.bars->setWidth(bar.high - bar.low);
    }
    cell.bars->setData(at, counts, true);
    const Characteristic& of = cell.summary.characteristic;
    cell.low = of.low ? addLine(cell, *of.low) : nullptr;
    cell.high = of.high ? addLine(cell, *of.high) : nullptr;
    cell.mean = cell.summary.mean95 ? addLine(cell, cell.summary.moments.mean) : nullptr;
}

QCPItemStraightLine* HistogramPlot::addLine(const Cell& cell, double value) {
    auto* line = new QCPItemStraightLine(this);
    for (QCPItemPosition* point : {line->point1, line->point2}) {
        point->setAxisRect(cell.rect);
        point->setAxes(cell.rect->axis(QCPAxis::atBottom), cell.rect->axis(QCPAxis::atLeft));
    }
    line->point1->setCoords(value, 0);
    line->point2->setCoords(value, 1);
    line->setClipAxisRect(cell.rect);
    line->setSelectable(false);
    return line;
}

/// The same axis of the other cells follows.
void HistogramPlot::link(const QCPAxis* moved) {
    if (m_linking) {
        return;
    }
    m_linking = true;
    for (const Cell& cell : m_cells) {
        if (cell.rect != moved->axisRect()) {
            cell.rect->axis(moved->axisType())->setRange(moved->range());
        }
    }
    m_linking = false;
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
    const double beside = room * (high - low);
    style::setSafeRange(*valueAxis(0), low - beside, high + beside);
    style::setSafeRange(*countAxis(0), 0, countRoom * most);
}

void HistogramPlot::setDimmed(bool dim) {
    if (m_dim != dim) {
        m_dim = dim;
        restyle();
    }
}

void HistogramPlot::restyle() {
    style::applyPalette(*this, palette());
    const auto colour = [this](style::Hue hue) {
        return style::dimmed(style::colour(hue, palette()), m_dim);
    };
    for (const Cell& cell : m_cells) {
        cell.header->setFont(font());
        cell.header->setTextColor(palette().color(QPalette::Text));
        for (QCPAxis* axis : cell.rect->axes()) {
            axis->setTickLabelFont(font());
            axis->setLabelFont(font());
        }
        cell.bars->setPen(QPen(palette().color(QPalette::Base), 1));
        cell.bars->setBrush(colour(style::Hue::sky));
        for (QCPItemStraightLine* limit : {cell.low, cell.high}) {
            if (limit) {
                limit->setPen(QPen(colour(style::Hue::vermilion), 2));
            }
        }
        if (cell.mean) {
            cell.mean->setPen(QPen(colour(style::Hue::blue), 1.5, Qt::DashLine));
        }
    }
}

QString HistogramPlot::name(const Characteristic& characteristic) {
    const std::string_view key = characteristic.name;
    for (int i = 0; i < constraintKinds; ++i) {
        const auto kind = static_cast<ConstraintKind>(i);
        if (key == constraintName(kind)) {
            return Names::constraint(kind);
        }
    }
    return key == "time" ? tr("Machining time") : tr("Mean diameter");
}

QString HistogramPlot::headingOf(const CharacteristicSummary& summary) const {
    const Characteristic& of = summary.characteristic;
    QString text = of.section < 0 ? tr("whole part") : Names::zone(of.zone, of.section);
    if (summary.cpk) {
        text += tr(", Cpk %1").arg(locale().toString(summary.cpk->value, 'f', 2));
    }
    return text;
}

void HistogramPlot::retranslate() {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(numbers);
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Cell& cell = m_cells[i];
        const Characteristic& of = cell.summary.characteristic;
        cell.header->setText(headingOf(cell.summary));
        cell.rect->axis(QCPAxis::atBottom)->setLabel(tr("%1, %2").arg(name(of), unitText(of.unit)));
        cell.rect->axis(QCPAxis::atLeft)->setLabel(i == 0 ? tr("Parts") : QString());
    }
}

void HistogramPlot::changeEvent(QEvent* event) {
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
    } else if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

} // namespace sparkout
