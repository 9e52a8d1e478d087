// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/scatter_plot.h"

#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;

constexpr double partSize = 5, worstSize = 11; ///< [px]
constexpr double nearEnough = 8;               ///< [px] a point is meant within
constexpr double scatterRoom = 0.05;

} // namespace

QString quantityName(const BatchOutcome& outcome, BatchQuantity quantity) {
    const Characteristic* const of = outcome.characteristicOf(quantity);
    return of ? QStringLiteral("%1, %2").arg(BatchText::full(*of), unitText(of->unit))
              : BatchText::factorAxis(outcome.factors[quantity]);
}

ScatterPlot::ScatterPlot(QWidget* parent) : ViewPlot(parent) {
    m_rect = addRect();
    for (QCPGraph** graph : {&m_good, &m_outside, &m_worst}) {
        *graph = addLine(*m_rect);
        (*graph)->setLineStyle(QCPGraph::lsNone);
        (*graph)->setAdaptiveSampling(false);
    }
    for (const Key key : {goodKey, outsideKey, worstKey}) {
        setKeyed(key, {graph(key)});
    }
    built();
}

void ScatterPlot::setBatch(BatchOutcomePtr outcome, BatchQuantity across, BatchQuantity up) {
    m_outcome = std::move(outcome);
    m_across = across;
    m_up = up;
    fill();
}

bool ScatterPlot::outside(std::size_t row) const {
    return m_outcome->isOutside(row, m_across) || m_outcome->isOutside(row, m_up);
}

void ScatterPlot::fill() {
    for (QCPItemStraightLine* line : m_limits) {
        removeItem(line);
    }
    m_limits.clear();
    for (QCPGraph* graph : {m_good, m_outside, m_worst}) {
        graph->data()->clear();
    }
    const std::size_t rows = m_outcome ? m_outcome->result.statistics.rows.size() : 0;
    for (std::size_t i = 0; i < rows; ++i) {
        const double x = m_outcome->valueOf(i, m_across), y = m_outcome->valueOf(i, m_up);
        if (!std::isfinite(x) || !std::isfinite(y)) {
            continue;
        }
        (outside(i) ? m_outside : m_good)->addData(x, y);
        if (m_outcome->result.statistics.rows[i].part == m_outcome->summary.worstPart) {
            m_worst->addData(x, y);
        }
    }
    if (m_outcome) {
        addLimits(m_across, true);
        addLimits(m_up, false);
    }
    contentSet();
}

void ScatterPlot::addLimits(BatchQuantity quantity, bool upright) {
    if (const Characteristic* of = m_outcome->characteristicOf(quantity)) {
        for (const std::optional<double>& limit : {of->low, of->high}) {
            if (limit) {
                m_limits.push_back(addRule(*m_rect, *limit, upright));
                setKeyed(limitsKey, {m_limits.back()});
            }
        }
    }
}

/// The points; limits only where they are near, or they would squeeze them.
void ScatterPlot::fit() {
    const auto fitAxis = [this](QCPAxis& axis, BatchQuantity quantity) {
        double low = 0, high = 0;
        bool any = false;
        for (std::size_t i = 0; i < m_outcome->result.statistics.rows.size(); ++i) {
            const double value = m_outcome->valueOf(i, quantity);
            if (std::isfinite(value)) {
                low = any ? std::min(low, value) : value;
                high = any ? std::max(high, value) : value;
                any = true;
            }
        }
        const double size = high - low;
        if (const Characteristic* of = m_outcome->characteristicOf(quantity)) {
            for (const std::optional<double>& limit : {of->low, of->high}) {
                if (limit && *limit > low - size && *limit < high + size) {
                    low = std::min(low, *limit);
                    high = std::max(high, *limit);
                }
            }
        }
        style::setRoomyRange(axis, low, high, scatterRoom, 1e-3);
    };
    if (m_outcome && m_outcome->quantityCount() > 0) {
        fitAxis(*m_rect->axis(QCPAxis::atBottom), m_across);
        fitAxis(*m_rect->axis(QCPAxis::atLeft), m_up);
    }
}

// --- what is shown ------------------------------------------------------------------------------

QCPGraph* ScatterPlot::graph(Key key) const {
    return key == goodKey ? m_good : key == outsideKey ? m_outside : m_worst;
}

LegendEntries ScatterPlot::legendEntries() const {
    LegendEntries entries;
    const auto add = [&](Key key, const QString& text) {
        entries.push_back(areaEntry(key, graph(key)->scatterStyle().pen().color(), text));
    };
    add(goodKey, tr("parts"));
    if (m_outside->dataCount() > 0) {
        add(outsideKey, tr("parts beyond a limit shown"));
    }
    if (m_worst->dataCount() > 0) {
        add(worstKey, tr("worst part"));
    }
    if (!m_limits.empty()) {
        entries.push_back(lineEntry(limitsKey, m_limits.front()->pen(), tr("drawing limits")));
    }
    return entries;
}

CsvTable ScatterPlot::table() const {
    CsvTable table;
    if (!m_outcome) {
        return table;
    }
    table.header << tr("Part") << quantityName(*m_outcome, m_across)
                 << quantityName(*m_outcome, m_up);
    const auto& rows = m_outcome->result.statistics.rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double x = m_outcome->valueOf(i, m_across), y = m_outcome->valueOf(i, m_up);
        if (shows(outside(i) ? outsideKey : goodKey)
            && m_rect->axis(QCPAxis::atBottom)->range().contains(x)
            && m_rect->axis(QCPAxis::atLeft)->range().contains(y)) {
            table.rows.push_back({static_cast<double>(rows[i].part + 1), x, y});
        }
    }
    return table;
}

QString ScatterPlot::valuesAt(const QPointF& at) const {
    const std::size_t rows = m_outcome ? m_outcome->result.statistics.rows.size() : 0;
    double nearest = nearEnough;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < rows; ++i) {
        const QPointF point(
            m_rect->axis(QCPAxis::atBottom)->coordToPixel(m_outcome->valueOf(i, m_across)),
            m_rect->axis(QCPAxis::atLeft)->coordToPixel(m_outcome->valueOf(i, m_up)));
        const double away = QLineF(point, at).length();
        if (away < nearest && shows(outside(i) ? outsideKey : goodKey)) {
            nearest = away;
            found = i;
        }
    }
    if (!found) {
        return {};
    }
    const auto value = [&](BatchQuantity quantity) {
        return QStringLiteral("%1 %2").arg(
            quantityName(*m_outcome, quantity),
            Names::significant(m_outcome->valueOf(*found, quantity), 4));
    };
    return tr("Part %1: %2; %3")
        .arg(Names::part(m_outcome->result.statistics.rows[*found].part), value(m_across),
             value(m_up));
}

// --- look and words -----------------------------------------------------------------------------

void ScatterPlot::restyle() {
    ViewPlot::restyle();
    const auto dots = [](QCPGraph& graph, const QColor& of) {
        graph.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(of), of, partSize));
    };
    dots(*m_good, toned(Drawn::goodPart));
    dots(*m_outside, toned(Drawn::partOutside));
    m_worst->setScatterStyle(QCPScatterStyle(
        QCPScatterStyle::ssCircle, QPen(toned(Drawn::worstPart), 2), Qt::NoBrush, worstSize));
    for (QCPItemStraightLine* line : m_limits) {
        line->setPen(QPen(toned(Drawn::limit), 1.5, Qt::DashLine));
    }
}

void ScatterPlot::setTexts() {
    if (m_outcome && m_outcome->quantityCount() > 0) {
        m_rect->axis(QCPAxis::atBottom)->setLabel(quantityName(*m_outcome, m_across));
        m_rect->axis(QCPAxis::atLeft)->setLabel(quantityName(*m_outcome, m_up));
    }
}

} // namespace sparkout
