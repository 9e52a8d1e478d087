// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/compare_chart.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/read_curves.h"
#include "ui/text/names.h"
#include "ui/text/time_unit.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr qsizetype longestRunName = 24;

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

std::vector<XY> CompareChart::line(std::size_t run, Quantity quantity) const {
    return polyline(pointsOf(run), quantity, Edge::mean, m_scales[run]);
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

CsvTable CompareChart::table(double from, double to,
                             const std::function<bool(const ComparedFeeds&)>& wanted,
                             const std::function<bool(Quantity)>& shown) const {
    CsvTable table;
    table.header << tr("run") << tr("stage") << tr("double stroke or revolution")
                 << tr("%1: from", "time").arg(timeLabel())
                 << tr("%1: to", "time").arg(timeLabel());
    std::vector<Quantity> columns;
    for (const Quantity quantity : quantities()) {
        if (shown(quantity)) {
            columns.push_back(quantity);
            table.header << quantityWithUnit(quantity);
        }
    }
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        if (!wanted(m_runs[run])) {
            continue;
        }
        for (const FeedPoint& p : pointsOf(run)) {
            const double begin = m_scales[run].at(p.start_s), end = m_scales[run].at(p.end_s);
            if (end <= from || begin >= to) {
                continue;
            }
            std::vector<CsvCell> row{m_runs[run].name, double(p.place.stage),
                                     double(p.place.cycleCount), begin, end};
            for (const Quantity quantity : columns) {
                row.emplace_back(valueOf(p, quantity, Edge::mean));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

} // namespace sparkout
