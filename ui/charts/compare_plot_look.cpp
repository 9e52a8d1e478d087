// SPDX-License-Identifier: GPL-3.0-or-later
// Words, colours, legend and table of the plot of compared runs.
#include "ui/charts/compare_plot.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/plot/run_dash.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr qsizetype longestRunName = 24;

/// The point at a time; null where the zone has none.
const FeedPoint* feedPointAt(const FeedPoints& points, double time_s) {
    const auto found = std::ranges::find_if(
        points, [time_s](const FeedPoint& p) { return p.start_s <= time_s && time_s < p.end_s; });
    return found == points.end() ? nullptr : &*found;
}

} // namespace

QColor ComparePlot::colourOf(Quantity quantity) const {
    return style::colour(style::drawnAs(quantity), palette());
}

void ComparePlot::restyle() {
    style::applyPalette(*this, palette());
    for (QCPAxisRect* rect : m_rects) {
        for (QCPAxis* axis : rect->axes()) {
            axis->setTickLabelFont(font());
            axis->setLabelFont(font());
        }
    }
    for (const Quantity quantity : quantities()) { // an axis has the colour of its curves
        axisOf(quantity)->setLabelColor(colourOf(quantity));
        axisOf(quantity)->setTickLabelColor(colourOf(quantity));
    }
    for (const Curve& curve : m_curves) {
        curve.graph->setPen(
            runPen(m_runs[curve.run].number, style::dimmed(colourOf(curve.quantity), isDimmed())));
    }
}

QString ComparePlot::timeLabel() const {
    bool strokes = false, turns = false;
    for (const ComparedFeeds& run : m_runs) {
        (run.feeds->operation->countsStrokes ? strokes : turns) = true;
    }
    switch (m_axis) {
    case CycleAxis::minutes: return tr("Time, min");
    case CycleAxis::seconds: return tr("Time, s");
    case CycleAxis::strokes:
        return strokes && turns ? tr("Double strokes or revolutions done")
               : turns          ? tr("Revolutions done")
                                : tr("Double strokes done");
    case CycleAxis::revolutions: return tr("Revolutions done");
    }
    return {};
}

/// For plots are low; the legend has the full names.
QString ComparePlot::briefName(Quantity quantity) {
    switch (quantity) {
    case Quantity::actual: return tr("Feed, µm");
    case Quantity::force: return tr("Force, N");
    case Quantity::actualSum: return tr("Σ feed,\nµm");
    case Quantity::left: return tr("Radius,\nµm");
    case Quantity::programmed: return tr("Programmed,\nµm");
    case Quantity::axialFeed: return tr("Axial,\nmm/min");
    case Quantity::came: return tr("Radius\nbefore, µm");
    case Quantity::programmedSum: return tr("Σ program-\nmed, µm");
    }
    return {};
}

void ComparePlot::labelAxes() {
    for (const Quantity quantity : quantities()) {
        axisOf(quantity)->setLabel(briefName(quantity));
    }
    m_rects[1]->axis(QCPAxis::atBottom)->setLabel(timeLabel());
}

void ComparePlot::setTexts() {
    labelAxes();
}

LegendEntries ComparePlot::legendEntries() const {
    LegendEntries entries;
    for (const Quantity quantity : quantities()) {
        const int key = static_cast<int>(quantity);
        entries.push_back({style::dimmed(colourOf(quantity), isDimmed()), Qt::SolidLine,
                           quantityName(quantity), key, m_choice.shows(key)});
    }
    for (const ComparedFeeds& run : m_runs) {
        const int key = runKey + run.number;
        entries.push_back({palette().color(QPalette::Text), Qt::SolidLine, run.name, key,
                           m_choice.shows(key), runDash(run.number)});
    }
    return entries;
}

QString ComparePlot::shortName(std::size_t run) const {
    const QString& name = m_runs[run].name;
    return name.size() > longestRunName ? name.left(longestRunName) + u'…' : name;
}

ReadCurves ComparePlot::readCurves() const {
    ReadCurves curves;
    QStringList names;
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        QString name = shortName(run);
        if (names.contains(name)) {
            name += QStringLiteral(" (%1)").arg(m_runs[run].number);
        }
        names << name;
        for (const Curve& curve : m_curves) {
            if (curve.run == run && curve.graph->visible()) {
                curves.push_back({name, quantityWithUnit(curve.quantity),
                                  quantityDigits(curve.quantity),
                                  [graph = curve.graph](double x) { return valueAt(*graph, x); }});
            }
        }
    }
    return curves;
}

CursorSubject ComparePlot::cursorSubject() {
    const auto scale = [this] { return m_scales.empty() ? CycleScale() : m_scales.front(); };
    return {[this] { return timeLabel(); }, [this] { return QCPRange(0, end()); },
            [this] { return readCurves(); }, [scale](double x) { return scale().time_s(x); },
            [scale](double time_s) { return scale().at(time_s); }};
}

/// One line, though names of the user's may be long.
QString ComparePlot::values(std::size_t run, double x) const {
    const ComparedFeeds& of = m_runs[run];
    const QString name = shortName(run);
    const FeedPoint* const p = feedPointAt(pointsOf(of), m_scales[run].time_s(x));
    if (!p) {
        return tr("%1: nothing is ground then").arg(name);
    }
    const QString stroke =
        (of.feeds->operation->countsStrokes ? tr("double stroke %1") : tr("revolution %1"))
            .arg(p->place.cycleCount);
    QString chosen;
    for (std::size_t row = 0; row < rowCount; ++row) {
        if (const Quantity q = m_second[row]; q != secondQuantities[row][0]) {
            chosen += QStringLiteral("; %1 %2").arg(
                quantityWithUnit(q), told(valueOf(*p, q, Edge::mean), quantityDigits(q)));
        }
    }
    return tr("%1, %2: feed %3, accumulated %4, radius %5 µm; force %6 N")
               .arg(name, stroke, Names::micrometres(p->actual_um.mean),
                    Names::micrometres(p->actualSum_um.mean),
                    Names::signedMicrometres(p->left_um.mean), Names::significant(p->force_n.mean))
           + chosen;
}

CsvTable ComparePlot::table() const {
    CsvTable table;
    table.header << tr("run") << tr("stage") << tr("double stroke or revolution")
                 << tr("%1: from", "time").arg(timeLabel())
                 << tr("%1: to", "time").arg(timeLabel());
    std::vector<Quantity> shown;
    for (const Quantity quantity : quantities()) {
        if (m_choice.shows(static_cast<int>(quantity))) {
            shown.push_back(quantity);
            table.header << quantityWithUnit(quantity);
        }
    }
    const QCPRange sight = m_rects[0]->axis(QCPAxis::atBottom)->range();
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        if (!m_choice.shows(runKey + m_runs[run].number)) {
            continue;
        }
        for (const FeedPoint& p : pointsOf(m_runs[run])) {
            const double from = m_scales[run].at(p.start_s), to = m_scales[run].at(p.end_s);
            if (to <= sight.lower || from >= sight.upper) {
                continue;
            }
            std::vector<CsvCell> row{m_runs[run].name, double(p.place.stage),
                                     double(p.place.cycleCount), from, to};
            for (const Quantity quantity : shown) {
                row.emplace_back(valueOf(p, quantity, Edge::mean));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

} // namespace sparkout
