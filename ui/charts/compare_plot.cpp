// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/compare_plot.h"

#include "ui/plot/hair_line.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/run_dash.h"

#include <QMouseEvent>

#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

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
