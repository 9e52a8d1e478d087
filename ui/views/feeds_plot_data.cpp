// SPDX-License-Identifier: GPL-3.0-or-later
// Filling the plots with the curves and bands of the visible span.
#include "ui/views/feeds_plot.h"

#include "ui/views/band_layer.h"
#include "ui/views/names.h"
#include "ui/views/plot_style.h"

#include <algorithm>
#include <limits>

namespace sparkout {

namespace {

// How many double strokes are in sight when the curves change their meaning.
constexpr double mostStrokesByRadius = 1.5;
constexpr double mostStrokesByPass = 10;
constexpr double mostStrokesWithSteps = 4.5;
constexpr double mostRevolutionsByRadius = 12;
constexpr double mostPassesDrawn = 500; ///< plunge: more are thinned

QCPGraphData toData(const XY& p) {
    return {p.x, p.y};
}

} // namespace

void FeedsPlot::refresh() {
    const Detail before = m_detail;
    const bool stepsBefore = m_stepsShown;
    chooseDetail();
    m_stepsShown = showsSteps();
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        fillColumn(i);
        fillBands(i);
    }
    scaleValues();
    if (before != m_detail) {
        labelAxes();
    }
    if (before != m_detail || stepsBefore != m_stepsShown) {
        emit contentChanged();
    }
}

void FeedsPlot::chooseDetail() {
    const double strokes = visibleStrokes();
    const bool traverse = m_series.operation == Operation::traverse;
    if (strokes <= (traverse ? mostStrokesByRadius : mostRevolutionsByRadius)) {
        m_detail = Detail::radius;
    } else if (strokes <= (traverse ? mostStrokesByPass : mostPassesDrawn)) {
        m_detail = Detail::pass;
    } else {
        m_detail = Detail::stroke;
    }
}

bool FeedsPlot::showsSteps() const {
    return m_series.operation == Operation::traverse && visibleStrokes() <= mostStrokesWithSteps;
}

void FeedsPlot::fillColumn(std::size_t index) {
    const FeedColumn& source = m_series.columns[index];
    Column& column = m_columns[index];
    switch (m_detail) {
    case Detail::stroke: column.points = within(source.strokes, m_from_s, m_to_s); break;
    case Detail::pass: column.points = within(source.passes, m_from_s, m_to_s); break;
    case Detail::radius:
        column.points = radiusPoints(m_series, source, m_outcome->trajectory, m_from_s, m_to_s);
        break;
    }
    for (const Curve& c : column.curves) {
        QVector<QCPGraphData> points;
        if (c.edge == Edge::mean || m_detail != Detail::radius) {
            const std::vector<XY> line = polyline(column.points, c.quantity, c.edge, m_scale);
            points.resize(static_cast<qsizetype>(line.size()));
            std::transform(line.begin(), line.end(), points.begin(), toData);
        }
        c.graph->data()->set(points, true);
    }
}

std::vector<Band> FeedsPlot::stepBands(const FeedColumn& column) const {
    std::vector<Band> bands;
    Place last;
    for (const FeedPoint& p : within(column.passes, m_from_s, m_to_s)) {
        const double from = m_scale.at(p.start_s), to = m_scale.at(p.end_s);
        if (!bands.empty() && last.step == p.place.step && last.cycleCount == p.place.cycleCount) {
            bands.back().to = to;
        } else {
            const QString name = Names::step(p.place.step);
            const QString meaning =
                tr("%1: %2").arg(name, Names::stepMeaning(p.place.zone, p.place.step));
            bands.push_back({from, to, colourOf(p.place.zone, p.place.step), name, meaning});
        }
        last = p.place;
    }
    return bands;
}

std::vector<Band> FeedsPlot::stageBands() const {
    std::vector<Band> bands;
    for (const StageSpan& span : m_series.stages) {
        const bool odd = span.stage % 2 == 1;
        QColor colour = style::colour(odd ? style::Hue::sky : style::Hue::yellow, palette());
        colour.setAlpha(odd ? 28 : 38);
        const QString name = tr("stage %1").arg(span.stage);
        bands.push_back({m_scale.at(span.start_s), m_scale.at(span.end_s), colour, name, name});
    }
    return bands;
}

void FeedsPlot::fillBands(std::size_t index) {
    const std::vector<Band> bands =
        showsSteps() ? stepBands(m_series.columns[index]) : stageBands();
    for (BandLayer* layer : m_columns[index].bands) {
        layer->setBands(bands);
    }
}

QCPRange FeedsPlot::valuesOf(std::initializer_list<Quantity> quantities) const {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const Column& column : m_columns) {
        for (const FeedPoint& p : column.points) {
            if (p.end_s < m_from_s || p.start_s > m_to_s) {
                continue;
            }
            for (Quantity q : quantities) {
                low = std::min(low, valueOf(p, q, Edge::low));
                high = std::max(high, valueOf(p, q, Edge::high));
            }
        }
    }
    return low <= high ? QCPRange(low, high) : QCPRange(0, 1);
}

void FeedsPlot::scaleValues() {
    const auto set = [this](std::size_t row, QCPAxis::AxisType type, double low, double high) {
        if (m_ownValues[row]) {
            return;
        }
        const double pad = high > low ? (high - low) * 0.06 : 1;
        for (Column& column : m_columns) {
            style::setSafeRange(*column.rects[row]->axis(type), low - (low == 0 ? 0 : pad),
                                high + pad);
        }
    };
    m_linking = true;
    const QCPRange feed = valuesOf({Quantity::programmed, Quantity::actual});
    set(0, QCPAxis::atLeft, std::min(0.0, feed.lower), feed.upper);
    const QCPRange sums = valuesOf({Quantity::programmedSum, Quantity::actualSum});
    set(1, QCPAxis::atLeft, m_detail == Detail::stroke ? 0 : sums.lower, sums.upper);
    const QCPRange radii = valuesOf({Quantity::came, Quantity::left});
    set(1, QCPAxis::atRight, radii.lower, radii.upper);
    const bool plunge = m_series.operation == Operation::plunge;
    const QCPRange last = valuesOf({plunge ? Quantity::force : Quantity::axialFeed});
    set(2, QCPAxis::atLeft, 0, last.upper);
    m_linking = false;
}

} // namespace sparkout
