// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/feeds_chart.h"

#include "ui/plot/feed_text.h"
#include "ui/text/names.h"
#include "ui/text/time_unit.h"

#include <algorithm>
#include <limits>

namespace sparkout {

namespace {

// Number of visible double strokes below which the curves show radii.
constexpr double mostStrokesByRadius = 1.5;
constexpr double mostStrokesByPass = 10;
constexpr double mostStrokesWithSteps = 4.5;
constexpr double mostRevolutionsByRadius = 12;
constexpr double mostPassesDrawn = 500; ///< plunge: more are thinned

} // namespace

void FeedsChart::setRun(OutcomePtr outcome, const std::vector<int>& shown) {
    m_outcome = std::move(outcome);
    m_scale = CycleScale(series(), m_axis);
    m_strokes = CycleScale(series(), CycleAxis::strokes);
    m_columns.resize(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        m_columns[i].index = static_cast<std::size_t>(shown[i]);
    }
}

void FeedsChart::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_scale = CycleScale(series(), axis);
}

void FeedsChart::setTimes(double from_s, double to_s) {
    m_from_s = from_s;
    m_to_s = to_s;
    m_detail = visibleDetail();
    m_steps = visibleSteps();
    for (Column& column : m_columns) {
        const FeedColumn& zone = series().columns[column.index];
        column.points = pointsOf(zone, m_detail, from_s, to_s);
        column.passes =
            m_detail == Detail::radius ? pointsOf(zone, Detail::pass, from_s, to_s) : FeedPoints();
    }
}

const FeedSeries& FeedsChart::series() const {
    static const FeedSeries none;
    return m_outcome ? m_outcome->feeds : none;
}

const FeedColumn& FeedsChart::source(std::size_t column) const {
    return series().columns.at(m_columns.at(column).index);
}

const FeedPoints& FeedsChart::points(std::size_t column) const {
    return m_columns[column].points;
}

QString FeedsChart::timeLabel() const {
    switch (m_axis) {
    case CycleAxis::time: return TimeUnit(series().end_s).titled(tr("Time"));
    case CycleAxis::strokes:
        return countsStrokes() ? tr("Double strokes done") : tr("Revolutions done");
    case CycleAxis::revolutions: return tr("Revolutions done");
    }
    return {};
}

// --- what is in sight ---------------------------------------------------------------------------

FeedsChart::Detail FeedsChart::visibleDetail() const {
    const double strokes = visibleStrokes();
    if (strokes <= (countsStrokes() ? mostStrokesByRadius : mostRevolutionsByRadius)) {
        return Detail::radius;
    }
    return strokes <= (countsStrokes() ? mostStrokesByPass : mostPassesDrawn) ? Detail::pass
                                                                              : Detail::stroke;
}

bool FeedsChart::showsSteps() const {
    return countsStrokes() && visibleStrokes() <= mostStrokesWithSteps;
}

std::vector<StepSpan> FeedsChart::stepsOf(std::size_t column) const {
    return stepSpans(source(column), m_outcome->trajectory, m_from_s, m_to_s);
}

FeedsChart::Steps FeedsChart::visibleSteps() const {
    Steps steps;
    for (std::size_t i = 0; showsSteps() && i < m_columns.size(); ++i) {
        const Zone zone = source(i).zone;
        for (const StepSpan& span : stepsOf(i)) {
            const StrokeStep step = strokeStep(zone, span.place.step);
            const bool inSight = span.end_s > m_from_s && span.start_s < m_to_s;
            if (inSight && std::ranges::none_of(steps, [step](const auto& known) {
                    return strokeStep(known.first, known.second) == step;
                })) {
                steps.emplace_back(zone, span.place.step);
            }
        }
    }
    // In the order of the double stroke.
    std::ranges::sort(steps, {}, [](const auto& s) { return strokeStep(s.first, s.second); });
    return steps;
}

FeedPoints FeedsChart::pointsOf(const FeedColumn& column, Detail detail, double from_s,
                                double to_s) const {
    const Trajectory& trajectory = m_outcome->trajectory;
    switch (detail) {
    case Detail::stroke: break;
    case Detail::pass: return passPoints(series(), column, trajectory, from_s, to_s);
    case Detail::radius: return radiusPoints(series(), column, trajectory, from_s, to_s);
    }
    return within(column.strokes, from_s, to_s);
}

// --- the curves ---------------------------------------------------------------------------------

bool FeedsChart::hasSpread(Quantity quantity) {
    return quantity != Quantity::programmed && quantity != Quantity::programmedSum
           && quantity != Quantity::axialFeed;
}

int FeedsChart::keyOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmedSum: return static_cast<int>(Quantity::programmed);
    case Quantity::actualSum: return static_cast<int>(Quantity::actual);
    default: return static_cast<int>(quantity);
    }
}

std::vector<XY> FeedsChart::line(std::size_t column, Quantity quantity, Edge edge) const {
    const Column& of = m_columns[column];
    if (goesByPasses(quantity)) {
        return polyline(of.passes, quantity, edge, m_scale);
    }
    return edge == Edge::mean || m_detail != Detail::radius
               ? polyline(of.points, quantity, edge, m_scale)
               : std::vector<XY>();
}

std::pair<double, double> FeedsChart::extremes(std::initializer_list<Quantity> quantities,
                                               const CurveChoice& choice) const {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    const bool spread = choice.shows(spreadKey);
    for (const Column& column : m_columns) {
        for (const FeedPoint& p : column.points) {
            if (p.end_s < m_from_s || p.start_s > m_to_s) {
                continue;
            }
            for (const Quantity q : quantities) {
                if (choice.shows(keyOf(q))) {
                    low = std::min(low, valueOf(p, q, spread ? Edge::low : Edge::mean));
                    high = std::max(high, valueOf(p, q, spread ? Edge::high : Edge::mean));
                }
            }
        }
    }
    return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
}

ReadCurve FeedsChart::readCurve(std::size_t column, Quantity quantity) const {
    const FeedColumn& zone = source(column);
    return {Names::zone(zone.zone, zone.section), quantityWithUnit(quantity),
            quantityDigits(quantity), [this, &zone, quantity](double x) {
                const double time_s = m_scale.time_s(x);
                const Detail detail = goesByPasses(quantity) ? Detail::pass : m_detail;
                return valueAt(
                    polyline(pointsOf(zone, detail, time_s, time_s), quantity, Edge::mean, m_scale),
                    x);
            }};
}

// --- the table ----------------------------------------------------------------------------------

std::vector<CsvCell> FeedsChart::place(const FeedColumn& zone, const FeedPoint& point) const {
    const Place& at = point.place;
    const auto count = [](int number, bool known) {
        return known ? CsvCell(double(number)) : CsvCell();
    };
    return {Names::zone(zone.zone, zone.section),
            double(at.stage),
            double(at.cycleCount),
            Names::step(at.step),
            count(at.revolution, at.revolution > 0),
            count(point.radius, point.radius >= 0),
            m_scale.at(point.start_s),
            m_scale.at(point.end_s)};
}

CsvTable FeedsChart::table(const CurveChoice& choice) const {
    CsvTable table;
    table.byPlace = true;
    table.header = {series().operation->hasZones ? tr("zone") : tr("section"),
                    tr("stage"),
                    countsStrokes() ? tr("double stroke") : tr("revolution"),
                    tr("step"),
                    tr("pass of the step"),
                    tr("radius no."),
                    tr("%1: from", "time").arg(timeLabel()),
                    tr("%1: to", "time").arg(timeLabel())};
    const bool spread = m_detail != Detail::radius && choice.shows(spreadKey);
    std::vector<std::pair<Quantity, Edge>> figures;
    for (int q = 0; q <= static_cast<int>(Quantity::force); ++q) {
        const auto quantity = static_cast<Quantity>(q);
        const bool drawn = quantity != Quantity::axialFeed || hasAxialFeed();
        if (m_columns.empty() || !choice.shows(keyOf(quantity)) || !drawn) {
            continue;
        }
        const QString name = quantityWithUnit(quantity);
        figures.emplace_back(quantity, Edge::mean);
        table.header << name;
        if (spread && hasSpread(quantity)) {
            figures.emplace_back(quantity, Edge::low);
            figures.emplace_back(quantity, Edge::high);
            table.header << tr("%1: minimum").arg(name) << tr("%1: maximum").arg(name);
        }
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        for (const FeedPoint& point : m_columns[i].points) {
            if (!(point.end_s > m_from_s && point.start_s < m_to_s)) {
                continue;
            }
            std::vector<CsvCell> row = place(source(i), point);
            for (const auto& [quantity, edge] : figures) {
                row.emplace_back(valueOf(point, quantity, edge));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

} // namespace sparkout
