// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/compare_plot.h"

#include "ui/chart/painted_layer.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr qsizetype longestRunName = 24;
constexpr double curveRoom = 0.06; ///< margin, relative to the values
/// The dash identifies the run, so in black and white the width identifies the axis.
constexpr std::array weights{1.3, 0.7};

} // namespace

void CompareChart::setRuns(std::vector<ComparedFeeds> runs) {
    m_runs = std::move(runs);
    setAxis(m_axis);
}

void CompareChart::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_scales.clear();
    for (const ComparedFeeds& run : m_runs) {
        m_scales.emplace_back(*run.feeds, m_axis, longest_s());
    }
}

std::array<Quantity, 4> CompareChart::quantities() const {
    return {Quantity::actual, m_second[0], Quantity::actualSum, m_second[1]};
}

const FeedPoints& CompareChart::pointsOf(std::size_t run) const {
    return m_runs[run].feeds->columns.at(m_runs[run].column).strokes;
}

double CompareChart::longest_s() const {
    double longest_s = 0;
    for (const ComparedFeeds& run : m_runs) {
        longest_s = std::max(longest_s, run.feeds->end_s);
    }
    return longest_s;
}

double CompareChart::end() const {
    double end = 0;
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        end = std::max(end, m_scales[run].at(m_runs[run].feeds->end_s));
    }
    return end;
}

// --- the charts ---------------------------------------------------------------------------------

LineChart CompareChart::cell(std::size_t row, const CurveChoice& choice) const {
    LineChart chart;
    chart.isFramed = true;
    chart.across = {.range = {0, end()}, .room = 0};
    const std::array<Quantity, 2> sides{quantities()[2 * row], quantities()[2 * row + 1]};
    std::array<ChartSpan, 2> values{{{0, 0}, {0, 0}}};
    const QStringList names = shortNames();
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        for (std::size_t side = 0; side < sides.size(); ++side) {
            const Quantity quantity = sides[side];
            ChartSeries series{.key = static_cast<int>(quantity),
                               .name = run == 0 ? quantityName(quantity) : QString(),
                               .colour = style::drawnAs(quantity),
                               .pen = runPen(m_runs[run].number, {}),
                               .points =
                                   polyline(pointsOf(run), quantity, Edge::mean, m_scales[run]),
                               .onSecond = side == 1};
            series.pen.setWidthF(series.pen.widthF() * weights[side]);
            for (const XY& point : series.points) {
                values[side].add(point.y);
            }
            if (choice.shows(runKey + m_runs[run].number)) {
                chart.read(series, quantityWithUnit(quantity), quantityDigits(quantity));
                chart.readings.back().curve.group = names[static_cast<qsizetype>(run)];
            } else {
                series.points.clear();
            }
            chart.series.insert(chart.series.begin() + static_cast<std::ptrdiff_t>(side),
                                std::move(series));
        }
    }
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const auto& [low, high] = values[side];
        const double room = (high - low) * curveRoom;
        (side == 0 ? chart.up : chart.second) = {.label = briefName(sides[side]),
                                                 .range = {low < 0 ? low - room : 0, high + room},
                                                 .room = 0,
                                                 .colour = style::drawnAs(sides[side])};
    }
    return chart;
}

ChartGrid CompareChart::grid(const CurveChoice& choice) const {
    ChartGrid grid{.caption = timeLabel(), .sharesValues = true};
    for (std::size_t row = 0; row < rowCount; ++row) {
        grid.cells.push_back(cell(row, choice));
    }
    grid.cells.front().readSpan = {0, end()};
    grid.cells.front().table = [this, choice] { return table(choice); };
    return grid;
}

// --- words --------------------------------------------------------------------------------------

QString CompareChart::timeLabel() const {
    bool strokes = false, turns = false;
    for (const ComparedFeeds& run : m_runs) {
        (run.feeds->operation->travels ? strokes : turns) = true;
    }
    switch (m_axis) {
    case CycleAxis::time: return TimeUnit(longest_s()).titled(tr("Time"));
    case CycleAxis::strokes:
        return strokes && turns ? tr("Double strokes or revolutions done")
               : turns          ? tr("Revolutions done")
                                : tr("Double strokes done");
    case CycleAxis::revolutions: return tr("Revolutions done");
    }
    return {};
}

QString CompareChart::briefName(Quantity quantity) {
    switch (quantity) {
    case Quantity::actual: return tr("Feed, µm");
    case Quantity::force: return tr("Force, N");
    case Quantity::actualSum: return tr("Σ feed, µm");
    case Quantity::left: return tr("Radius, µm");
    case Quantity::programmed: return tr("Programmed, µm");
    case Quantity::axialFeed: return tr("Axial, mm/min");
    case Quantity::came: return tr("Radius before, µm");
    case Quantity::programmedSum: return tr("Σ programmed, µm");
    }
    return {};
}

QString CompareChart::shortName(std::size_t run) const {
    const QString& name = m_runs[run].name;
    return name.size() > longestRunName ? name.left(longestRunName) + u'…' : name;
}

QStringList CompareChart::shortNames() const {
    QStringList names;
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        QString name = shortName(run);
        if (names.contains(name)) {
            name += QStringLiteral(" (%1)").arg(m_runs[run].number);
        }
        names << name;
    }
    return names;
}

/// On one line, although the user's names may be long.
QString CompareChart::valuesAt(std::size_t run, double x) const {
    const QString name = shortName(run);
    const FeedPoint* const p = feedPointAt(pointsOf(run), m_scales[run].time_s(x));
    if (!p) {
        return tr("%1: nothing is ground then").arg(name);
    }
    const bool strokes = m_runs[run].feeds->operation->travels;
    const QString stroke =
        (strokes ? tr("double stroke %1") : tr("revolution %1")).arg(p->place.cycleCount);
    QString chosen;
    for (std::size_t row = 0; row < rowCount; ++row) {
        if (const Quantity q = m_second[row]; q != secondQuantities[row][0]) {
            chosen += QStringLiteral("; %1 %2").arg(
                quantityWithUnit(q), stated(valueOf(*p, q, Edge::mean), quantityDigits(q)));
        }
    }
    return tr("%1, %2: feed %3, accumulated %4, radius %5 µm; force %6 N")
               .arg(name, stroke, Names::micrometres(p->actual_um.mean),
                    Names::micrometres(p->actualSum_um.mean),
                    Names::signedMicrometres(p->left_um.mean), Names::significant(p->force_n.mean))
           + chosen;
}

ChartTable CompareChart::table(const CurveChoice& choice) const {
    ChartTable table;
    table.cells.header << tr("run") << tr("stage") << tr("double stroke or revolution")
                       << tr("%1: from", "time").arg(timeLabel())
                       << tr("%1: to", "time").arg(timeLabel());
    std::vector<Quantity> columns;
    for (const Quantity quantity : quantities()) {
        if (choice.shows(static_cast<int>(quantity))) {
            columns.push_back(quantity);
            table.cells.header << quantityWithUnit(quantity);
        }
    }
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        for (const FeedPoint& p : pointsOf(run)) {
            const double begin = m_scales[run].at(p.start_s), end = m_scales[run].at(p.end_s);
            std::vector<CsvCell> row{m_runs[run].name, double(p.place.stage),
                                     double(p.place.cycleCount), begin, end};
            for (const Quantity quantity : columns) {
                row.emplace_back(valueOf(p, quantity, Edge::mean));
            }
            table.cells.rows.push_back(std::move(row));
            table.places.push_back({.across = {begin, end}, .key = runKey + m_runs[run].number});
        }
    }
    return table;
}

ComparePlot::ComparePlot(QWidget* parent)
    : ChartPlot(parent)
    , m_momentLine(new HairLine(*this, HairLine::Role::moment))
    , m_hairLine(new HairLine(*this)) {
    setPlottingHints(QCP::phFastPolylines);
    onClick([this](const QPointF& at) {
        if (const auto place = placeAt(at); place && !runs().empty()) {
            emit timeClicked(m_chart.scale(0).time_s(place->x));
        }
    });
    setGrid([this] { return m_chart.grid(choice()); });
}

void ComparePlot::setSecond(std::size_t row, Quantity quantity) {
    const bool all = visibleRange() == m_fitted;
    m_chart.setSecond(row, quantity);
    remake();
    const ChartSpan& values = chart(row).second.range;
    style::setSafeRange(second(row), values.low, values.high);
    m_fitted = all ? visibleRange() : m_fitted;
}

bool ComparePlot::setRuns(std::vector<ComparedFeeds> runs) {
    const bool all = visibleRange() == m_fitted;
    const QString axis = m_chart.timeLabel();
    m_chart.setRuns(std::move(runs));
    remake();
    const bool isOtherUnit = m_chart.timeLabel() != axis; // of the visible range
    if (isOtherUnit) {
        m_hairLine->setAt({});
    }
    if (all || isOtherUnit) {
        fit();
    }
    setMoment(m_moment_s);
    return isOtherUnit;
}

void ComparePlot::setAxis(CycleAxis axis) {
    m_chart.setAxis(axis);
    m_hairLine->setAt({});
    remake();
    fit();
    setMoment(m_moment_s);
}

void ComparePlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s && !runs().empty() ? std::optional(m_chart.scale(0).at(*time_s))
                                                  : std::nullopt);
}

void ComparePlot::fit() {
    ChartPlot::fit();
    m_fitted = visibleRange();
}

QList<QCPAxis*> ComparePlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- reading ------------------------------------------------------------------------------------

QString ComparePlot::valuesAt(const QPointF& at) const {
    const auto place = placeAt(at);
    if (!place || runs().empty()) {
        return {};
    }
    QStringList lines{m_chart.valuesAt(0, place->x)};
    if (const std::size_t other = otherRunAt(at); other > 0) {
        lines << m_chart.valuesAt(other, place->x);
    }
    return lines.join(u'\n');
}

/// Another run with the visible curve that passes nearest, above or below; if there is none, the
/// last.
std::size_t ComparePlot::otherRunAt(const QPointF& at) const {
    const std::size_t last = runs().size() - 1, cell = *cellAt(at);
    const std::vector<ChartSeries>& series = chart(cell).series;
    std::size_t nearest = last;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < series.size(); ++i) {
        const std::size_t run = last - i / 2; // two series a run
        const auto value = run > 0 && shows(series[i].key)
                               ? valueAt(series[i].points, across(cell).pixelToCoord(at.x()))
                               : std::nullopt;
        const QCPAxis& axis = series[i].onSecond ? second(cell) : up(cell);
        if (const double away = value ? std::abs(axis.coordToPixel(*value) - at.y()) : least;
            away < least) {
            least = away;
            nearest = run;
        }
    }
    return nearest;
}

void ComparePlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    const auto place = placeAt(event->position());
    m_hairLine->setAt(place && !runs().empty() ? std::optional(place->x) : std::nullopt);
    ViewPlot::onMouse(event);
}

void ComparePlot::pointAway() {
    m_hairLine->setAt({});
    ViewPlot::pointAway();
}

CursorSubject ComparePlot::cursorSubject() {
    const auto scale = [this] { return runs().empty() ? CycleScale() : m_chart.scale(0); };
    CursorSubject subject = ViewPlot::cursorSubject();
    subject.axis = [this] { return m_chart.timeLabel(); };
    subject.keep = [scale](double x) { return scale().time_s(x); };
    subject.place = [scale](double time_s) { return scale().at(time_s); };
    return subject;
}

// --- the legend ---------------------------------------------------------------------------------

LegendEntries ComparePlot::legendEntries() const {
    LegendEntries entries = ChartPlot::legendEntries();
    for (const ComparedFeeds& run : runs()) {
        const int key = CompareChart::runKey + run.number;
        // A neutral colour, since the entry shows the dash.
        entries.push_back({palette().color(QPalette::PlaceholderText), Qt::SolidLine, run.name, key,
                           shows(key), runDash(run.number)});
    }
    return entries;
}

/// The other quantities, or the other runs.
LegendEntries ComparePlot::besides(int key) const {
    LegendEntries alike = legendEntries();
    std::erase_if(alike, [key](const LegendEntry& entry) {
        return (entry.key < CompareChart::runKey) != (key < CompareChart::runKey);
    });
    return alike;
}

} // namespace sparkout
