// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/compare_plot.h"

#include "ui/plot/hair_line.h"
#include "ui/plot/plot_click.h"
#include "ui/plot/plot_style.h"

#include <algorithm>
#include <limits>

namespace sparkout {

namespace {
constexpr double curveRoom = 0.06; ///< of the values
} // namespace

ComparePlot::ComparePlot(QWidget* parent) : ViewPlot(parent) {
    setPlottingHints(QCP::phFastPolylines);
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    build();
    retranslate();
    restyle();
    connect(this, &QCustomPlot::mouseMove, this, &ComparePlot::onMouse);
    onPlotClick(*this, [this](const QPointF& at) {
        if (const QCPAxisRect* rect = axisRectAt(at); rect && !m_runs.empty()) {
            emit timeClicked(
                presentScale().time_s(rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
        }
    });
    setBuilt();
}

void ComparePlot::build() {
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    auto* margins = new QCPMarginGroup(this);
    for (std::size_t row = 0; row < m_rects.size(); ++row) {
        auto* rect = new QCPAxisRect(this, true);
        plotLayout()->addElement(static_cast<int>(row), 0, rect);
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
        for (QCPAxis* axis : rect->axes()) {
            style::setUpAxis(*axis);
            axis->ticker()->setTickCount(4);
            axis->setVisible(true);
        }
        rect->axis(QCPAxis::atTop)->setTicks(false);
        rect->axis(QCPAxis::atRight)->grid()->setVisible(false);
        rect->axis(QCPAxis::atRight)->setTickLabels(true);
        rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(8);
        rect->axis(QCPAxis::atBottom)->setTickLabels(row + 1 == m_rects.size());
        m_rects[row] = rect;
    }
    const auto changed = QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged);
    for (const std::size_t row : {0, 1}) {
        QCPAxis* const other = m_rects[1 - row]->axis(QCPAxis::atBottom);
        connect(m_rects[row]->axis(QCPAxis::atBottom), changed, other,
                [other](const QCPRange& range) { other->setRange(range); });
    }
    connect(this, &QCustomPlot::afterLayout, this, &ComparePlot::fitTexts);
    m_momentLine = new HairLine(*this, HairLine::Role::moment);
    m_hairLine = new HairLine(*this);
}

/// Names as long as the plots are high, and as many numbers as there is room for.
void ComparePlot::fitTexts() {
    constexpr int least = 2, most = 8;
    const int room = QFontMetrics(font()).horizontalAdvance(QStringLiteral("0000.0"));
    for (QCPAxisRect* rect : m_rects) {
        style::fitValueAxes(*rect, font());
        QCPAxis* const below = rect->axis(QCPAxis::atBottom);
        const int count = std::clamp(rect->width() / room, least, most);
        if (below->ticker()->tickCount() != count) {
            below->ticker()->setTickCount(count);
            replot(rpQueuedReplot);
        }
    }
}

std::array<Quantity, 4> ComparePlot::quantities() const {
    return {Quantity::actual, m_second[0], Quantity::actualSum, m_second[1]};
}

QCPAxis* ComparePlot::axisOf(Quantity quantity) const {
    const std::array<Quantity, 4> all = quantities();
    const auto index = static_cast<std::size_t>(std::ranges::find(all, quantity) - all.begin());
    return m_rects.at(index / 2)->axis(index % 2 == 0 ? QCPAxis::atLeft : QCPAxis::atRight);
}

void ComparePlot::setSecond(std::size_t row, Quantity quantity) {
    const bool all = ranges() == m_fitted;
    m_second.at(row) = quantity;
    fill();
    fitValues(quantity);
    m_fitted = all ? ranges() : m_fitted;
    labelAxes();
    emit contentChanged();
}

const FeedPoints& ComparePlot::pointsOf(const ComparedFeeds& run) const {
    return run.feeds->columns.at(run.column).strokes;
}

void ComparePlot::setRuns(std::vector<ComparedFeeds> runs) {
    const bool all = m_fitted.empty() || ranges() == m_fitted;
    m_runs = std::move(runs);
    fill();
    if (all) {
        fit();
    }
    labelAxes();
    setMoment(m_moment_s);
    emit contentChanged();
}

void ComparePlot::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_hairLine->setAt({});
    fill();
    fit();
    labelAxes();
    setMoment(m_moment_s);
}

void ComparePlot::fill() {
    clearGraphs();
    m_curves.clear();
    m_scales.clear();
    for (const ComparedFeeds& run : m_runs) {
        m_scales.emplace_back(*run.feeds, m_axis);
    }
    for (std::size_t run = m_runs.size(); run-- > 0;) { // the present one on top
        for (const Quantity quantity : quantities()) {
            QCPAxis* const value = axisOf(quantity);
            QCPGraph* const graph = addGraph(value->axisRect()->axis(QCPAxis::atBottom), value);
            graph->removeFromLegend();
            graph->setSelectable(QCP::stNone);
            QVector<QCPGraphData> points;
            for (const XY& p :
                 polyline(pointsOf(m_runs[run]), quantity, Edge::mean, m_scales[run])) {
                points.append({p.x, p.y});
            }
            graph->data()->set(points, true);
            m_curves.push_back({run, quantity, graph});
        }
    }
    showCurves();
    restyle();
}

void ComparePlot::showCurves() {
    for (const Curve& curve : m_curves) {
        curve.graph->setVisible(m_choice.shows(static_cast<int>(curve.quantity))
                                && m_choice.shows(runKey + m_runs[curve.run].number));
    }
}

void ComparePlot::toggleCurve(int key) {
    m_choice.toggle(key);
    showCurves();
    emit contentChanged();
}

/// Of the quantities or of the runs.
void ComparePlot::showOnly(int key) {
    LegendEntries alike = legendEntries();
    std::erase_if(
        alike, [key](const LegendEntry& entry) { return (entry.key < runKey) != (key < runKey); });
    m_choice.only(key, alike);
    showCurves();
    emit contentChanged();
}

void ComparePlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s && !m_runs.empty() ? std::optional(presentScale().at(*time_s))
                                                  : std::nullopt);
}

// --- what is in sight ---------------------------------------------------------------------------

PlotHistory::State ComparePlot::ranges() const {
    PlotHistory::State state;
    for (const QCPAxisRect* rect : m_rects) {
        for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft, QCPAxis::atRight}) {
            const QCPRange range = rect->axis(side)->range();
            state.insert(state.end(), {range.lower, range.upper});
        }
    }
    return state;
}

double ComparePlot::end() const {
    double end = 0;
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        end = std::max(end, m_scales[run].at(m_runs[run].feeds->end_s));
    }
    return end;
}

void ComparePlot::fitValues(Quantity quantity) {
    double low = 0, high = 0;
    for (const Curve& curve : m_curves) {
        if (curve.quantity == quantity) {
            bool found = false;
            const QCPRange range = curve.graph->getValueRange(found);
            low = found ? std::min(low, range.lower) : low;
            high = found ? std::max(high, range.upper) : high;
        }
    }
    const double room = (high - low) * curveRoom;
    style::setSafeRange(*axisOf(quantity), low < 0 ? low - room : low, high + room);
}

void ComparePlot::fit() {
    style::setSafeRange(*m_rects[0]->axis(QCPAxis::atBottom), 0, end());
    style::setSafeRange(*m_rects[1]->axis(QCPAxis::atBottom), 0, end());
    for (const Quantity quantity : quantities()) {
        fitValues(quantity);
    }
    m_fitted = ranges();
}

QList<QCPAxis*> ComparePlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

QCPGraph* ComparePlot::curve(int number, Quantity quantity) const {
    for (const Curve& curve : m_curves) {
        if (m_runs[curve.run].number == number && curve.quantity == quantity) {
            return curve.graph;
        }
    }
    return nullptr;
}

// --- the mouse ----------------------------------------------------------------------------------

void ComparePlot::onMouse(QMouseEvent* event) {
    const QCPAxisRect* const rect = axisRectAt(event->pos());
    if (event->buttons() != Qt::NoButton || m_runs.empty()) {
        return;
    }
    if (!rect || !rect->rect().contains(event->pos())) {
        pointAway();
        return;
    }
    const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
    m_hairLine->setAt(x);
    QStringList lines{values(0, x)};
    const Curve* const nearest = nearestCurve(event->pos());
    const std::size_t other = nearest && nearest->run > 0 ? nearest->run : m_runs.size() - 1;
    if (other > 0) {
        lines << values(other, x);
    }
    emit pointed(lines.join(u'\n'));
}

/// The visible curve of another run that passes nearest by, up or down.
const ComparePlot::Curve* ComparePlot::nearestCurve(const QPointF& at) const {
    const Curve* nearest = nullptr;
    double least = std::numeric_limits<double>::max();
    for (const Curve& curve : m_curves) {
        const QCPAxis* const key = curve.graph->keyAxis();
        const bool here = key->axisRect()->rect().contains(at.toPoint());
        if (curve.run == 0 || !here || !curve.graph->visible() || curve.graph->data()->isEmpty()) {
            continue;
        }
        const auto point = curve.graph->data()->findBegin(key->pixelToCoord(at.x()));
        const double y = curve.graph->valueAxis()->coordToPixel(point->value);
        if (std::abs(y - at.y()) < least) {
            least = std::abs(y - at.y());
            nearest = &curve;
        }
    }
    return nearest;
}

void ComparePlot::pointAway() {
    m_hairLine->setAt({});
    ViewPlot::pointAway();
}

} // namespace sparkout
