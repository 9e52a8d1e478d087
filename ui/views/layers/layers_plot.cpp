// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_plot.h"

#include "core/units.h"
#include "ui/text/names.h"
#include "ui/views/layers/layer_stack.h"
#include "ui/views/layers/layers_look.h"

#include <algorithm>
#include <functional>

namespace sparkout {

namespace {

using style::Drawn;
using units::umPerMm;

constexpr double roomAbove = 0.06, roomBelow = 0.08; ///< margins, as shares of the heights
constexpr int fieldAlpha = 60;

} // namespace

LayersPlot::LayersPlot(QWidget* parent) : PartPlot(parent) {
    new LayerStack(*this);
    setChart([this] { return made(); });
    onClick([this](const QPointF& at) {
        if (const std::optional<Hit> hit = layerAt(at)) {
            emit strokeClicked(m_series.spans[hit->span].last);
        }
    });
    built();
}

void LayersPlot::setSeries(LayerSeries series) {
    const auto blank = [](const LayerSeries& s) {
        return s.columns.empty() ? 0 : s.columns.front().blank_mm;
    };
    const bool same = series.length_mm == m_series.length_mm
                      && series.target_mm == m_series.target_mm && blank(series) == blank(m_series);
    m_series = std::move(series);
    m_done = allLayers(m_series);
    remake();
    if (!same) {
        fit();
    }
}

void LayersPlot::setDone(LayersDone done) {
    m_done = std::move(done);
}

double LayersPlot::radiusAfter_mm(std::size_t column, std::size_t count) const {
    return m_series.columns[column].blank_mm
           - m_series.removalSign * sumDone_mm(m_series, m_done, column, count);
}

double LayersPlot::above_um(double radius_mm) const {
    return (radius_mm - m_series.target_mm) * umPerMm;
}

// --- what is shown ------------------------------------------------------------------------------

LineChart LayersPlot::made() const {
    LineChart chart = partChart();
    if (m_series.columns.empty()) {
        return chart;
    }
    std::vector<LayerColumn> columns = m_series.columns;
    std::ranges::sort(columns, {},
                      [](const LayerColumn& column) { return column.stretch.from_mm; });
    ChartSpan span;
    // A height held over each stretch, with a step to the next.
    const auto heights = [&](const auto& radiusOf) {
        std::vector<XY> line;
        for (const LayerColumn& column : columns) {
            const double height_um = above_um(std::invoke(radiusOf, column));
            line.insert(line.end(),
                        {{column.stretch.from_mm, height_um}, {column.stretch.to_mm, height_um}});
            span.add(height_um);
        }
        return line;
    };
    const auto upper = heights([this](const auto&) { return m_series.upperLimit_mm; });
    const auto lower = heights([this](const auto&) { return m_series.lowerLimit_mm; });
    const auto target = heights([this](const auto&) { return m_series.target_mm; });
    const ChartSeries edge{.key = fieldKey, .colour = Drawn::toleranceField, .pen = linePen(1)};
    chart.series.assign(2, edge);
    chart.series[0].points = upper;
    chart.series[1].points = lower;
    using enum ChartSeries::Kind; // the paths are drawn above the target
    chart.series.push_back({.key = blankKey,
                            .name = tr("initial radius"),
                            .kind = path,
                            .pen = linePen(1.5, Qt::DashLine),
                            .points = heights(&LayerColumn::blank_mm)});
    chart.series.push_back({.key = finalKey,
                            .name = tr("final radius"),
                            .kind = path,
                            .pen = linePen(2),
                            .points = heights(&LayerColumn::final_mm)});
    chart.series.push_back({.key = targetKey,
                            .name = tr("target"),
                            .colour = Drawn::toleranceField,
                            .pen = linePen(1.5, Qt::DashLine),
                            .points = target});
    chart.series.push_back({.key = fieldKey,
                            .name = tr("tolerance band"),
                            .kind = band,
                            .colour = Drawn::toleranceField,
                            .points = upper,
                            .lower = lower,
                            .alpha = fieldAlpha});
    chart.across.range = {0, m_series.length_mm};
    chart.up.range = {span.low - roomBelow * span.size(), span.high + roomAbove * span.size()};
    chart.table = [this] { return doneTable(); };
    return chart;
}

LegendEntries LayersPlot::legendEntries() const {
    LegendEntries entries = LayersLook::stages(m_series, choice(), palette());
    for (const LegendEntry& entry : PartPlot::legendEntries()) {
        entries.push_back(entry);
    }
    return entries;
}

QRectF LayersPlot::layerRect(std::size_t column, std::size_t span) const {
    if (span >= m_done.count || !shows(m_series.spans[span].stage)) {
        return {};
    }
    const LayerColumn& of = m_series.columns[column];
    const auto corner = [this](double length_mm, double radius_mm) {
        return pixelOf({length_mm, above_um(radius_mm)});
    };
    return QRectF(corner(of.stretch.from_mm, radiusAfter_mm(column, span)),
                  corner(of.stretch.to_mm, radiusAfter_mm(column, span + 1)))
        .normalized();
}

// --- mouse --------------------------------------------------------------------------------------

std::optional<LayersPlot::Hit> LayersPlot::layerAt(const QPointF& at) const {
    if (!cell().rect().contains(at.toPoint())) {
        return {};
    }
    for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
        for (std::size_t i = 0; i < m_done.count; ++i) {
            if (layerRect(j, i).contains(at)) {
                return Hit{j, i};
            }
        }
    }
    return {};
}

QString LayersPlot::valuesAt(const QPointF& at) const {
    const std::optional<Hit> hit = layerAt(at);
    return hit ? LayersLook::values(m_series, m_done, hit->column, hit->span) : QString();
}

ChartTable LayersPlot::doneTable() const {
    ChartTable whole;
    CsvTable& table = whole.cells;
    table.header << tr("Stage") << tr("From double stroke or revolution")
                 << tr("To double stroke or revolution");
    for (const LayerColumn& column : m_series.columns) {
        const QString name = Names::zone(column.zone, column.section);
        table.header << tr("%1, taken off, µm").arg(name) << tr("%1, so far, µm").arg(name);
    }
    for (std::size_t i = 0; i < m_done.count; ++i) {
        const LayerSpan& span = m_series.spans[i];
        std::vector<CsvCell> row{double(span.stage), double(span.first), double(span.last)};
        for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
            const double before = sumDone_mm(m_series, m_done, j, i);
            const double after = sumDone_mm(m_series, m_done, j, i + 1);
            row.emplace_back((after - before) * umPerMm);
            row.emplace_back(after * umPerMm);
        }
        table.rows.push_back(std::move(row));
        whole.places.push_back({.key = span.stage});
    }
    return whole;
}

} // namespace sparkout
