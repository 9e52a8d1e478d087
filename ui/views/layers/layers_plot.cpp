// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_plot.h"

#include "core/units.h"
#include "ui/plot/painted_layer.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/views/layers/layers_look.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Paints the layers of a LayersPlot, the metal below them, and the axis of rotation.
class LayerStack : public PaintedLayer {
public:
    explicit LayerStack(LayersPlot& plot);

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    void drawMetal(QCPPainter& painter) const;
    void drawLayers(QCPPainter& painter) const;

    const LayersPlot& m_plot;
};

constexpr int bodyAlpha = 30, edgeAlpha = 150;
constexpr double outlined = 4; ///< layers lower than this have no outline [px]

LayerStack::LayerStack(LayersPlot& plot)
    : PaintedLayer(*plot.cell(), QStringLiteral("bands"), Edges::sharp), m_plot(plot) {}

QRect LayerStack::clipRect() const {
    return m_plot.painted();
}

void LayerStack::draw(QCPPainter* painter) {
    if (m_plot.series().columns.empty()) {
        return;
    }
    drawMetal(*painter);
    drawLayers(*painter);
    m_plot.drawPartAxis(*painter);
}

/// Draws the finished part, and the stock still to be removed.
void LayerStack::drawMetal(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const QCPAxis* const x = m_rect->axis(QCPAxis::atBottom);
    const QCPAxis* const y = m_rect->axis(QCPAxis::atLeft);
    const bool bore = series.removalSign < 0;
    const auto pixel = [&](double radius_mm) {
        return y->coordToPixel((radius_mm - series.target_mm) * units::umPerMm);
    };
    for (std::size_t j = 0; j < series.columns.size(); ++j) {
        const LayerColumn& column = series.columns[j];
        const double left = x->coordToPixel(column.stretch.from_mm);
        const double right = x->coordToPixel(column.stretch.to_mm);
        const auto fill = [&](double from, double to, const QColor& colour) {
            painter.fillRect(
                QRectF(QPointF(left, std::min(from, to)), QPointF(right, std::max(from, to))),
                colour);
        };
        const double last = pixel(series.radiusAfter_mm(column, series.spans.size()));
        const double foot = bore ? m_rect->top() : m_rect->bottom() + 1.0;
        if (bore ? last > foot : last < foot) {
            fill(last, foot, style::thinned(palette.color(QPalette::Text), bodyAlpha));
        }
        fill(pixel(m_plot.radiusAfter_mm(j, m_plot.done().count)), last,
             LayersLook::uncut(palette));
    }
}

void LayerStack::drawLayers(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const std::size_t done = m_plot.done().count;
    const QPen edge(style::thinned(palette.color(QPalette::Text), edgeAlpha), 0);
    const QPen newestEdge(style::thinned(palette.color(QPalette::Text), 255), 2);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < done; ++i) {
        const QColor colour =
            style::dimmed(LayersLook::layer(series, i, palette), m_plot.isDimmed());
        const bool newest = i + 1 == done && i + 1 < series.spans.size();
        painter.setPen(newest ? newestEdge : edge);
        for (std::size_t j = 0; j < series.columns.size(); ++j) {
            const QRectF rect = m_plot.layerRect(j, i);
            if (rect.isEmpty()) {
                continue;
            }
            painter.fillRect(rect, colour);
            if (newest || rect.height() >= outlined) {
                painter.drawRect(rect);
            }
        }
    }
}

using style::Drawn;
using units::umPerMm;

constexpr double roomAbove = 0.06, roomBelow = 0.08; ///< margins, as shares of the heights
constexpr int fieldAlpha = 60;

/// A height held over each stretch, with a step to the next.
template <typename ValueOf>
void setSteps(QCPGraph& graph, const LayerSeries& series, ValueOf valueOf) {
    std::vector<const LayerColumn*> columns;
    for (const LayerColumn& column : series.columns) {
        columns.push_back(&column);
    }
    std::ranges::sort(columns, {}, [](const LayerColumn* c) { return c->stretch.from_mm; });
    QVector<double> x, y;
    for (const LayerColumn* column : columns) {
        const double value = (valueOf(*column) - series.target_mm) * umPerMm;
        x << column->stretch.from_mm << column->stretch.to_mm;
        y << value << value;
    }
    graph.setData(x, y, true);
}

} // namespace

LayersPlot::LayersPlot(QWidget* parent) : PartPlot(parent) {
    new LayerStack(*this);
    for (QCPGraph** graph : {&m_lower, &m_upper, &m_target, &m_blank, &m_final}) {
        *graph = addLine(*cell());
        (*graph)->setAdaptiveSampling(false);
    }
    m_upper->setChannelFillGraph(m_lower);
    setKeyed(fieldKey, {m_lower, m_upper});
    setKeyed(targetKey, {m_target});
    setKeyed(blankKey, {m_blank});
    setKeyed(finalKey, {m_final});
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
    fill();
    if (!same) {
        fit();
    }
    emit contentChanged();
}

void LayersPlot::setDone(LayersDone done) {
    m_done = std::move(done);
}

double LayersPlot::radiusAfter_mm(std::size_t column, std::size_t count) const {
    return m_series.columns[column].blank_mm
           - m_series.removalSign * sumDone_mm(m_series, m_done, column, count);
}

void LayersPlot::fill() {
    setSteps(*m_lower, m_series, [this](const LayerColumn&) { return m_series.lowerLimit_mm; });
    setSteps(*m_upper, m_series, [this](const LayerColumn&) { return m_series.upperLimit_mm; });
    setSteps(*m_target, m_series, [this](const LayerColumn&) { return m_series.target_mm; });
    setSteps(*m_blank, m_series, [](const LayerColumn& column) { return column.blank_mm; });
    setSteps(*m_final, m_series, [](const LayerColumn& column) { return column.final_mm; });
    fillBands();
    showChoice();
}

void LayersPlot::fit() {
    if (m_series.columns.empty()) {
        return;
    }
    double low = (m_series.lowerLimit_mm - m_series.target_mm) * umPerMm;
    double high = (m_series.upperLimit_mm - m_series.target_mm) * umPerMm;
    for (const LayerColumn& column : m_series.columns) {
        for (const double radius : {column.blank_mm, column.final_mm}) {
            low = std::min(low, (radius - m_series.target_mm) * umPerMm);
            high = std::max(high, (radius - m_series.target_mm) * umPerMm);
        }
    }
    const double size = high - low;
    style::setSafeRange(*cell()->axis(QCPAxis::atBottom), 0, m_series.length_mm);
    style::setSafeRange(*cell()->axis(QCPAxis::atLeft), low - roomBelow * size,
                        high + roomAbove * size);
}

// --- what is shown ------------------------------------------------------------------------------

QCPGraph* LayersPlot::graph(Key key) const {
    switch (key) {
    case fieldKey: return m_upper;
    case targetKey: return m_target;
    case blankKey: return m_blank;
    case finalKey: break;
    }
    return m_final;
}

LegendEntries LayersPlot::legendEntries() const {
    LegendEntries entries = LayersLook::stages(m_series, choice(), palette());
    entries.push_back(lineEntry(blankKey, m_blank->pen(), tr("initial radius")));
    entries.push_back(lineEntry(finalKey, m_final->pen(), tr("final radius")));
    entries.push_back(lineEntry(targetKey, m_target->pen(), tr("target")));
    entries.push_back(areaEntry(fieldKey, m_upper->brush().color(), tr("tolerance band")));
    return entries;
}

QRectF LayersPlot::layerRect(std::size_t column, std::size_t span) const {
    if (span >= m_done.count || !shows(m_series.spans[span].stage)) {
        return {};
    }
    const LayerColumn& of = m_series.columns[column];
    const QCPAxis* const x = cell()->axis(QCPAxis::atBottom);
    const auto pixel = [this](double radius_mm) {
        return cell()
            ->axis(QCPAxis::atLeft)
            ->coordToPixel((radius_mm - m_series.target_mm) * umPerMm);
    };
    const double from = pixel(radiusAfter_mm(column, span));
    const double to = pixel(radiusAfter_mm(column, span + 1));
    return {QPointF(x->coordToPixel(of.stretch.from_mm), std::min(from, to)),
            QPointF(x->coordToPixel(of.stretch.to_mm), std::max(from, to))};
}

// --- mouse --------------------------------------------------------------------------------------

std::optional<LayersPlot::Hit> LayersPlot::layerAt(const QPointF& at) const {
    if (!cell()->rect().contains(at.toPoint())) {
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

// --- look and words -----------------------------------------------------------------------------

void LayersPlot::restyle() {
    PartPlot::restyle();
    const QColor field = toned(Drawn::toleranceField);
    m_lower->setPen(field);
    m_upper->setPen(field);
    m_target->setPen({field, 1.5, Qt::DashLine});
    m_blank->setPen({ink(), 1.5, Qt::DashLine});
    m_final->setPen({ink(), 2});
    m_upper->setBrush(style::dimmed(
        style::filling(style::colour(Drawn::toleranceField, palette()), fieldAlpha, palette()),
        isDimmed()));
}

CsvTable LayersPlot::table() const {
    CsvTable table;
    table.header << tr("Stage") << tr("From double stroke or revolution")
                 << tr("To double stroke or revolution");
    for (const LayerColumn& column : m_series.columns) {
        const QString name = Names::zone(column.zone, column.section);
        table.header << tr("%1, taken off, µm").arg(name) << tr("%1, so far, µm").arg(name);
    }
    for (std::size_t i = 0; i < m_done.count; ++i) {
        const LayerSpan& span = m_series.spans[i];
        if (!shows(span.stage)) {
            continue;
        }
        std::vector<CsvCell> row{double(span.stage), double(span.first), double(span.last)};
        for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
            const double before = sumDone_mm(m_series, m_done, j, i);
            const double after = sumDone_mm(m_series, m_done, j, i + 1);
            row.emplace_back((after - before) * umPerMm);
            row.emplace_back(after * umPerMm);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
