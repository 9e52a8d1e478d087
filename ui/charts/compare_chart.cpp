// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/compare_chart.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/run_dash.h"
#include "ui/text/names.h"
#include "ui/text/time_unit.h"

#include <algorithm>
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

} // namespace sparkout
