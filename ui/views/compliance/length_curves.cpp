// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/length_curves.h"

#include "core/project/part.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout {

QString LengthCurves::axisLabel() const {
    return tr("Diameter from the middle of the field, µm");
}

QString LengthCurves::placeLabel() const {
    return tr("From the headstock end of the ground length, mm");
}

QCPGraph* LengthCurves::addGraph(int key) {
    QCPGraph* graph = m_plot.addLine(m_rect);
    graph->setVisible(shows(key));
    m_graphs.push_back({graph, key});
    return graph;
}

void LengthCurves::applyChoice() {
    for (const Keyed& keyed : m_graphs) {
        keyed.graph->setVisible(shows(keyed.key));
    }
}

void LengthCurves::setShown(bool shown) {
    m_shown = shown;
    applyChoice();
}

void LengthCurves::toggle(int key) {
    m_choice.toggle(key);
    applyChoice();
}

void LengthCurves::only(int key) {
    m_choice.only(key, legendEntries());
    applyChoice();
}

QCPRange LengthCurves::values() const {
    QCPRange all;
    bool any = false;
    for (const Keyed& keyed : m_graphs) {
        bool found = false;
        const QCPRange range = keyed.graph->getValueRange(found);
        if (found && keyed.key != limitsKey) {
            all = any ? all.expanded(range) : range;
            any = true;
        }
    }
    if (!any) {
        return {};
    }
    all.expand(0.0);
    constexpr double farAway = 3;
    if (m_limit_um < farAway * std::max(-all.lower, all.upper)) {
        all.expand(QCPRange(-m_limit_um, m_limit_um));
    }
    constexpr double room = 0.08;
    const double more = room * std::max(all.size(), 1e-3);
    return {all.lower - more, all.upper + more};
}

LegendEntry LengthCurves::entry(int key, QColor colour, Qt::PenStyle pen,
                                const QString& text) const {
    return {std::move(colour), pen, text, key, m_choice.shows(key)};
}

ReadCurves LengthCurves::readCurves() const {
    ReadCurves curves;
    for (const LegendEntry& entry : legendEntries()) {
        std::vector<QCPGraph*> drawn;
        for (const Keyed& keyed : m_graphs) {
            const auto data = keyed.graph->data();
            const bool along = data->size() > 1 && data->at(0)->key < (data->constEnd() - 1)->key
                               && keyed.graph->lineStyle() != QCPGraph::lsNone;
            if (keyed.key == entry.key && entry.key != limitsKey && keyed.graph->visible()
                && along) {
                drawn.push_back(keyed.graph);
            }
        }
        const bool spread = drawn.size() == 2; // the lower edge first
        for (const QCPGraph* graph : drawn) {
            const QString edge =
                graph == drawn.front() ? tr("%1: minimum, µm") : tr("%1: maximum, µm");
            const QString one = tr("%1, µm");
            curves.push_back({QString(), (spread ? edge : one).arg(entry.text), digits(),
                              [graph](double x) { return valueAt(*graph, x); }});
        }
    }
    return curves;
}

void LengthCurves::takeField(const Part& part) {
    m_middle_um = (part.upper_deviation_um + part.lower_deviation_um) / 2;
    m_limit_um = (part.upper_deviation_um - part.lower_deviation_um) / 2;
}

void LengthCurves::drawLimits(const Part& part) {
    takeField(part);
    for (int side = 0; side < 2; ++side) {
        if (!m_limits[side]) {
            m_limits[side] = addGraph(limitsKey);
            restyleLimits();
        }
        const double limit = side == 0 ? -m_limit_um : m_limit_um;
        m_limits[side]->setData({0, part.length_mm}, {limit, limit}, true);
    }
}

void LengthCurves::clearLimits() {
    for (QCPGraph* limit : m_limits) {
        if (limit) {
            limit->data()->clear();
        }
    }
}

void LengthCurves::restyleLimits() {
    for (QCPGraph* limit : m_limits) {
        if (limit) {
            limit->setPen(QPen(m_plot.toned(style::Drawn::limit), 1.5, Qt::DashLine));
        }
    }
}

LegendEntry LengthCurves::limitsEntry() const {
    return entry(limitsKey, m_plot.toned(style::Drawn::limit), Qt::DashLine,
                 tr("limits of the field, ±%1 µm").arg(Names::significant(m_limit_um)));
}

} // namespace sparkout
