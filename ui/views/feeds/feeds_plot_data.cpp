// SPDX-License-Identifier: GPL-3.0-or-later
// Filling the plots with the curves and bands of the visible span.
#include "ui/views/feeds/feeds_plot.h"

#include "ui/plot/band_layer.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"

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
    const auto stepsBefore = m_steps;
    chooseDetail();
    m_steps = stepsInSight();
    for (Column& column : m_columns) {
        fillColumn(column);
    }
    fillBands();
    scaleValues();
    if (before != m_detail) {
        labelAxes();
    }
    if (before != m_detail || stepsBefore != m_steps) {
        emit contentChanged();
    }
}

void FeedsPlot::chooseDetail() {
    const double strokes = visibleStrokes();
    if (strokes <= (countsStrokes() ? mostStrokesByRadius : mostRevolutionsByRadius)) {
        m_detail = Detail::radius;
    } else if (strokes <= (countsStrokes() ? mostStrokesByPass : mostPassesDrawn)) {
        m_detail = Detail::pass;
    } else {
        m_detail = Detail::stroke;
    }
}

bool FeedsPlot::showsSteps() const {
    return countsStrokes() && visibleStrokes() <= mostStrokesWithSteps;
}

std::vector<std::pair<Zone, Step>> FeedsPlot::stepsInSight() const {
    std::vector<std::pair<Zone, Step>> steps;
    for (const Column& column : m_columns) {
        const FeedColumn& zone = series().columns[column.index];
        if (!showsSteps()) {
            continue;
        }
        for (const StepSpan& span : stepSpans(zone, m_outcome->trajectory, m_from_s, m_to_s)) {
            const StrokeStep step = strokeStep(zone.zone, span.place.step);
            const bool inSight = span.end_s > m_from_s && span.start_s < m_to_s;
            if (inSight && std::ranges::none_of(steps, [step](const auto& known) {
                    return strokeStep(known.first, known.second) == step;
                })) {
                steps.emplace_back(zone.zone, span.place.step);
            }
        }
    }
    // In the order of the double stroke.
    std::ranges::sort(steps, {}, [](const auto& s) { return strokeStep(s.first, s.second); });
    return steps;
}

FeedPoints FeedsPlot::pointsOf(const FeedColumn& column, Detail detail, double from_s,
                               double to_s) const {
    const Trajectory& trajectory = m_outcome->trajectory;
    switch (detail) {
    case Detail::stroke: break;
    case Detail::pass: return passPoints(series(), column, trajectory, from_s, to_s);
    case Detail::radius: return radiusPoints(series(), column, trajectory, from_s, to_s);
    }
    return within(column.strokes, from_s, to_s);
}

void FeedsPlot::fillColumn(Column& column) {
    const FeedColumn& source = series().columns[column.index];
    column.points = pointsOf(source, m_detail, m_from_s, m_to_s);
    // Each radius has its own Σa: joined, they would saw. Their mean and spread grow pass by pass.
    FeedPoints passes;
    if (m_detail == Detail::radius) {
        passes = pointsOf(source, Detail::pass, m_from_s, m_to_s);
    }
    for (const Curve& c : column.curves) {
        const bool byPass = m_detail == Detail::radius && c.quantity == Quantity::actualSum;
        QVector<QCPGraphData> points;
        if (c.edge == Edge::mean || byPass || m_detail != Detail::radius) {
            const std::vector<XY> line =
                polyline(byPass ? passes : column.points, c.quantity, c.edge, m_scale);
            points.resize(static_cast<qsizetype>(line.size()));
            std::transform(line.begin(), line.end(), points.begin(), toData);
        }
        c.graph->data()->set(points, true);
    }
}

std::vector<Band> FeedsPlot::stepBands(const FeedColumn& column) const {
    std::vector<Band> bands;
    for (const StepSpan& span : stepSpans(column, m_outcome->trajectory, m_from_s, m_to_s)) {
        const Place& place = span.place;
        const QString name = Names::step(place.step);
        const QString meaning = tr("%1: %2").arg(name, Names::stepMeaning(place.zone, place.step));
        bands.push_back({m_scale.at(span.start_s),
                         m_scale.at(span.end_s),
                         stepColour(place.zone, place.step, palette()),
                         name,
                         {},
                         meaning});
    }
    return bands;
}

std::vector<Band> FeedsPlot::stageBands() const {
    std::vector<Band> bands;
    for (const StageSpan& span : series().stages) {
        const bool odd = span.stage % 2 == 1;
        QColor colour =
            style::colour(odd ? style::Drawn::oddStage : style::Drawn::evenStage, palette());
        colour.setAlpha(odd ? 28 : 38);
        const QString name = tr("stage %1").arg(span.stage);
        bands.push_back({m_scale.at(span.start_s), m_scale.at(span.end_s), colour, name,
                         tr("st. %1", "stage, short").arg(span.stage), name});
    }
    return bands;
}

void FeedsPlot::fillBands() {
    for (Column& column : m_columns) {
        const std::vector<Band> bands =
            showsSteps() ? stepBands(series().columns[column.index]) : stageBands();
        for (BandLayer* layer : column.bands) {
            layer->setBands(bands);
        }
    }
}

/// What the user hid is neither drawn nor scaled to.
void FeedsPlot::showCurves() {
    for (Column& column : m_columns) {
        for (const Curve& c : column.curves) {
            c.graph->setVisible(shows(c.quantity)
                                && (c.edge == Edge::mean || m_choice.shows(spreadKey)));
        }
    }
    scaleValues();
    emit contentChanged();
}

/// Extremes of the shown ones of the quantities within the visible span; (0, 0) if none is shown.
QCPRange FeedsPlot::valuesOf(std::initializer_list<Quantity> quantities) const {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    const bool spread = m_choice.shows(spreadKey);
    for (const Column& column : m_columns) {
        for (const FeedPoint& p : column.points) {
            if (p.end_s < m_from_s || p.start_s > m_to_s) {
                continue;
            }
            for (Quantity q : quantities) {
                if (shows(q)) {
                    low = std::min(low, valueOf(p, q, spread ? Edge::low : Edge::mean));
                    high = std::max(high, valueOf(p, q, spread ? Edge::high : Edge::mean));
                }
            }
        }
    }
    return low <= high ? QCPRange(low, high) : QCPRange(0, 0);
}

void FeedsPlot::scaleValues() {
    const auto set = [this](std::size_t row, QCPAxis::AxisType type, double low, double high) {
        if (m_values[row].own) {
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
    const QCPRange force = valuesOf({Quantity::force});
    if (hasAxialFeed()) {
        set(2, QCPAxis::atLeft, 0, valuesOf({Quantity::axialFeed}).upper);
        set(2, QCPAxis::atRight, 0, force.upper);
    } else {
        set(2, QCPAxis::atLeft, 0, force.upper);
    }
    m_linking = false;
    fitColumns();
}

} // namespace sparkout
