// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/feeds_chart.h"

#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

// Number of visible double strokes below which the curves show radii.
constexpr double mostStrokesByRadius = 1.5;
constexpr double mostStrokesByPass = 10;
constexpr double mostStrokesWithSteps = 4.5;
constexpr double mostRevolutionsByRadius = 12;
constexpr double mostPassesDrawn = 500; ///< plunge: more are thinned
constexpr double valuesPad = 0.06;      ///< margin, as a share of the visible values
constexpr int spreadAlpha = 64;

bool hasSpread(Quantity quantity) {
    return quantity != Quantity::programmed && quantity != Quantity::programmedSum
           && quantity != Quantity::axialFeed;
}

} // namespace

void FeedsChart::setRun(OutcomePtr outcome, const std::vector<int>& shown) {
    m_outcome = std::move(outcome);
    m_times.scale = CycleScale(series(), m_axis);
    m_times.end_s = series().end_s;
    m_strokes = CycleScale(series(), CycleAxis::strokes);
    m_columns.resize(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        m_columns[i].index = static_cast<std::size_t>(shown[i]);
    }
}

void FeedsChart::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_times.scale = CycleScale(series(), axis);
}

void FeedsChart::setTimes(double from_s, double to_s) {
    m_times.from_s = from_s;
    m_times.to_s = to_s;
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

// --- visible range ------------------------------------------------------------------------------

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
    return stepSpans(source(column), m_outcome->trajectory, m_times.from_s, m_times.to_s);
}

FeedsChart::Steps FeedsChart::visibleSteps() const {
    Steps steps;
    for (std::size_t i = 0; showsSteps() && i < m_columns.size(); ++i) {
        const Zone zone = source(i).zone;
        for (const StepSpan& span : stepsOf(i)) {
            const StrokeStep step = strokeStep(zone, span.place.step);
            const bool inSight = span.end_s > m_times.from_s && span.start_s < m_times.to_s;
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
        return polyline(of.passes, quantity, edge, m_times.scale);
    }
    return edge == Edge::mean || m_detail != Detail::radius
               ? polyline(of.points, quantity, edge, m_times.scale)
               : std::vector<XY>();
}

ChartSpan FeedsChart::extremes(const std::vector<Quantity>& quantities,
                               const CurveChoice& choice) const {
    ChartSpan span;
    const bool spread = choice.shows(spreadKey);
    for (const Column& column : m_columns) {
        for (const FeedPoint& p : column.points) {
            if (p.end_s < m_times.from_s || p.start_s > m_times.to_s) {
                continue;
            }
            for (const Quantity q : quantities) {
                if (choice.shows(keyOf(q))) {
                    span.add(valueOf(p, q, spread ? Edge::low : Edge::mean));
                    span.add(valueOf(p, q, spread ? Edge::high : Edge::mean));
                }
            }
        }
    }
    return span.empty() ? ChartSpan{0, 0} : span;
}

ReadCurve FeedsChart::readCurve(std::size_t column, Quantity quantity) const {
    const FeedColumn& zone = source(column);
    return {Names::zone(zone.zone, zone.section), quantityWithUnit(quantity),
            quantityDigits(quantity), [this, run = m_outcome, &zone, quantity](double x) {
                const double time_s = m_times.scale.time_s(x);
                const Detail detail = goesByPasses(quantity) ? Detail::pass : m_detail;
                return valueAt(polyline(pointsOf(zone, detail, time_s, time_s), quantity,
                                        Edge::mean, m_times.scale),
                               x);
            }};
}

// --- the charts ---------------------------------------------------------------------------------

std::vector<Quantity> FeedsChart::quantities(std::size_t row, bool onSecond) const {
    using enum Quantity;
    switch (row) {
    case 0: return onSecond ? std::vector<Quantity>() : std::vector{actual, programmed};
    case 1: return onSecond ? std::vector{came, left} : std::vector{actualSum, programmedSum};
    default: break;
    }
    if (hasAxialFeed()) {
        return {onSecond ? force : axialFeed};
    }
    return onSecond ? std::vector<Quantity>() : std::vector{force};
}

/// An axis is named by its last quantity.
ChartAxis FeedsChart::axis(std::size_t row, bool onSecond, const CurveChoice& choice) const {
    const std::vector<Quantity> drawn = quantities(row, onSecond);
    ChartAxis axis;
    axis.room = 0;
    if (drawn.empty()) {
        return axis;
    }
    ChartSpan span = extremes(drawn, choice);
    const bool isWhole = m_detail == Detail::stroke;
    switch (drawn.back()) {
    case Quantity::programmed:
        axis.label = !countsStrokes() ? tr("Feed, µm\nper revolution")
                     : isWhole        ? tr("Feed, µm per\ndouble stroke")
                                      : tr("Feed, µm\nper pass");
        axis.shorter = {tr("Feed, µm"), tr("µm")};
        span.low = std::min(span.low, 0.0);
        break;
    case Quantity::programmedSum:
        axis.label = tr("Accumulated\nfeed, µm");
        axis.shorter = {tr("Σ feed,\nµm"), tr("µm")};
        span.low = isWhole ? 0 : span.low;
        break;
    case Quantity::left:
        axis.label = tr("Radius above\ntarget, µm");
        axis.shorter = {tr("Radius,\nµm"), tr("µm")};
        break;
    case Quantity::axialFeed:
        axis.label = tr("Axial feed,\nmm/min");
        axis.shorter = {tr("Axial,\nmm/min"), tr("mm/min")};
        span.low = 0;
        break;
    default:
        axis.label = tr("Normal\nforce, N");
        axis.shorter = {tr("Force, N"), tr("N")};
        span.low = 0;
        break;
    }
    const double pad = span.high > span.low ? span.size() * valuesPad : 1;
    axis.range = {span.low == 0 ? 0 : span.low - pad, span.high + pad};
    return axis;
}

LineChart FeedsChart::cell(std::size_t column, std::size_t row, const CurveChoice& choice) const {
    LineChart chart;
    chart.isFramed = true;
    chart.namesBands = row == 0;
    if (row == 0) {
        const FeedColumn& zone = source(column);
        const QString form = zone.gauge ? tr("%1 (gauge)") : QStringLiteral("%1");
        chart.headings << form.arg(Names::zoneFull(zone.zone, zone.section))
                       << form.arg(Names::zone(zone.zone, zone.section));
    }
    for (const bool onSecond : {true, false}) {
        for (const Quantity quantity : quantities(row, onSecond)) {
            const style::Drawn drawn = style::drawnAs(quantity);
            ChartSeries mean{.key = keyOf(quantity),
                             .name = quantityName(quantity),
                             .colour = drawn,
                             .pen = style::line(drawn, {}),
                             .points = line(column, quantity, Edge::mean),
                             .onSecond = onSecond};
            if (hasSpread(quantity) && choice.shows(spreadKey)) {
                chart.series.push_back({.key = mean.key,
                                        .kind = ChartSeries::Kind::band,
                                        .colour = drawn,
                                        .points = line(column, quantity, Edge::high),
                                        .lower = line(column, quantity, Edge::low),
                                        .alpha = spreadAlpha,
                                        .onSecond = onSecond});
            }
            chart.readings.push_back({mean.key, readCurve(column, quantity)});
            chart.series.push_back(std::move(mean));
        }
    }
    chart.placeText = [this, column](double x) {
        return feedText(points(column), m_times.scale.time_s(x), series(),
                        m_detail == Detail::stroke);
    };
    return chart;
}

ChartGrid FeedsChart::grid(const CurveChoice& choice) const {
    ChartGrid grid{.columns = columnCount(), .caption = timeLabel(), .sharesValues = true};
    for (std::size_t row = 0; !isEmpty() && row < rowCount; ++row) {
        const ChartAxis up = axis(row, false, choice), second = axis(row, true, choice);
        for (std::size_t column = 0; column < columnCount(); ++column) {
            LineChart chart = cell(column, row, choice);
            chart.up = up;
            chart.second = second;
            chart.bands = showsSteps() ? stepBands(column) : stageBands();
            grid.cells.push_back(std::move(chart));
        }
    }
    if (!grid.cells.empty()) {
        grid.cells.front().table = [this, choice] { return ChartTable{table(choice), {}}; };
    }
    return grid;
}

std::vector<Band> FeedsChart::stepBands(std::size_t column) const {
    std::vector<Band> bands;
    for (const StepSpan& span : stepsOf(column)) {
        const Place& place = span.place;
        const QString name = Names::step(place.step);
        const QString meaning = tr("%1: %2").arg(name, Names::stepMeaning(place.zone, place.step));
        const auto colour = [zone = place.zone, step = place.step](const QPalette& palette) {
            return stepColour(zone, step, palette);
        };
        bands.push_back({m_times.scale.at(span.start_s),
                         m_times.scale.at(span.end_s),
                         colour,
                         name,
                         {},
                         meaning});
    }
    return bands;
}

std::vector<Band> FeedsChart::stageBands() const {
    std::vector<Band> bands;
    for (const StageSpan& span : series().stages) {
        const bool odd = span.stage % 2 == 1;
        const auto colour = [odd](const QPalette& palette) {
            return style::filling(
                style::colour(odd ? style::Drawn::oddStage : style::Drawn::evenStage, palette),
                odd ? 28 : 38, palette);
        };
        const QString name = tr("stage %1").arg(span.stage);
        bands.push_back({m_times.scale.at(span.start_s), m_times.scale.at(span.end_s), colour, name,
                         tr("st. %1", "stage, short").arg(span.stage), name});
    }
    return bands;
}

QColor FeedsChart::stepColour(Zone zone, Step step, const QPalette& palette) {
    const auto index = static_cast<std::size_t>(strokeStep(zone, step));
    return style::thinned(tone(style::stepOfStroke(index, palette), palette),
                          style::isDark(palette) ? 75 : 85);
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
            m_times.scale.at(point.start_s),
            m_times.scale.at(point.end_s)};
}

CsvTable FeedsChart::table(const CurveChoice& choice) const {
    CsvTable table;
    table.byPlace = true;
    table.header = {series().operation->travels ? tr("zone") : tr("section"),
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
            if (!(point.end_s > m_times.from_s && point.start_s < m_times.to_s)) {
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
