// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn, as a table.
#include "ui/views/feeds/feeds_plot.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/plot_cursors.h"
#include "ui/text/names.h"

namespace sparkout {

namespace {

/// A column of numbers: a quantity, or an edge of its spread.
struct Figure {
    Quantity quantity;
    Edge edge;
};

bool within(const FeedPoint& point, double from_s, double to_s) {
    return point.end_s > from_s && point.start_s < to_s;
}

} // namespace

/// Of the curve as it is drawn in the present detail, also where it is out of sight.
std::optional<double> FeedsPlot::readValue(const FeedColumn& column, Quantity quantity,
                                           double x) const {
    const bool byPass = m_detail == Detail::radius && quantity == Quantity::actualSum;
    const double time_s = m_scale.time_s(x);
    const FeedPoints points = pointsOf(column, byPass ? Detail::pass : m_detail, time_s, time_s);
    return valueAt(polyline(points, quantity, Edge::mean, m_scale), x);
}

ReadCurves FeedsPlot::readCurves() const {
    ReadCurves curves;
    for (const Column& column : m_columns) {
        const FeedColumn& zone = series().columns[column.index];
        for (const Curve& c : column.curves) {
            if (c.edge == Edge::mean && shows(c.quantity)) {
                curves.push_back({Names::zone(zone.zone, zone.section),
                                  quantityWithUnit(c.quantity), quantityDigits(c.quantity),
                                  [this, &zone, quantity = c.quantity](double x) {
                                      return readValue(zone, quantity, x);
                                  }});
            }
        }
    }
    return curves;
}

CursorSubject FeedsPlot::cursorSubject() {
    return {[this] { return timeLabel(); },
            [this] { return QCPRange(0, m_scale.at(series().end_s)); },
            [this] { return readCurves(); }, [this](double x) { return m_scale.time_s(x); },
            [this](double time_s) { return m_scale.at(time_s); }};
}

CsvTable FeedsPlot::table() const {
    CsvTable table;
    table.byPlace = true;
    std::vector<Figure> figures;
    const bool byRadius = m_detail == Detail::radius;
    const bool spread = !byRadius && m_choice.shows(spreadKey);
    table.header = {series().operation->hasZones ? tr("zone") : tr("section"),
                    tr("stage"),
                    countsStrokes() ? tr("double stroke") : tr("revolution"),
                    tr("step"),
                    tr("pass of the step"),
                    tr("radius no."),
                    tr("%1: from", "time").arg(timeLabel()),
                    tr("%1: to", "time").arg(timeLabel())};
    for (int q = 0; q <= static_cast<int>(Quantity::force); ++q) {
        const auto quantity = static_cast<Quantity>(q);
        if (m_columns.empty() || !shows(quantity) || !curve(0, quantity, Edge::mean)) {
            continue;
        }
        const QString name = quantityWithUnit(quantity);
        figures.push_back({quantity, Edge::mean});
        table.header << name;
        if (spread && curve(0, quantity, Edge::low)) {
            figures.push_back({quantity, Edge::low});
            figures.push_back({quantity, Edge::high});
            table.header << tr("%1: smallest").arg(name) << tr("%1: largest").arg(name);
        }
    }
    for (const Column& column : m_columns) {
        const FeedColumn& zone = series().columns[column.index];
        for (const FeedPoint& p : column.points) {
            if (!within(p, m_from_s, m_to_s)) {
                continue;
            }
            const Place& place = p.place;
            const auto count = [](int number, bool known) {
                return known ? CsvCell(double(number)) : CsvCell();
            };
            std::vector<CsvCell> row{Names::zone(zone.zone, zone.section),
                                     double(place.stage),
                                     double(place.cycleCount),
                                     Names::step(place.step),
                                     count(place.revolution, place.revolution > 0),
                                     count(p.radius, p.radius >= 0),
                                     m_scale.at(p.start_s),
                                     m_scale.at(p.end_s)};
            for (const Figure& f : figures) {
                row.emplace_back(valueOf(p, f.quantity, f.edge));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

} // namespace sparkout
