// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/compare_plot.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/plot/run_dash.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {
constexpr double curveRoom = 0.06;    ///< margin, relative to the values
constexpr QSize legiblePlot(120, 80); ///< least size
} // namespace

ComparePlot::ComparePlot(QWidget* parent) : ViewPlot(parent) {
    setPlottingHints(QCP::phFastPolylines);
    build();
    onClick([this](const QPointF& at) {
        if (const QCPAxisRect* rect = axisRectAt(at); rect && !runs().empty()) {
            emit timeClicked(
                m_chart.scale(0).time_s(rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
        }
    });
    built();
}

void ComparePlot::build() {
    plotLayout()->setRowSpacing(0);
    auto* margins = new QCPMarginGroup(this);
    for (std::size_t row = 0; row < m_rects.size(); ++row) {
        QCPAxisRect* const rect = addRect(static_cast<int>(row));
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
        rect->setMinimumSize(legiblePlot);
        for (QCPAxis* axis : style::axesOf(*rect)) {
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
    tie({m_rects.begin(), m_rects.end()}, QCPAxis::atBottom);
    connect(this, &QCustomPlot::afterLayout, this, &ComparePlot::fitTexts);
    m_momentLine = new HairLine(*this, HairLine::Role::moment);
    m_hairLine = new HairLine(*this);
}

/// Fits the names to the height of the plots, and the number of ticks to their space.
void ComparePlot::fitTexts() {
    constexpr int least = 2, most = 8;
    const int room = QFontMetrics(font()).horizontalAdvance(QStringLiteral("0000.0"));
    for (QCPAxisRect* rect : m_rects) {
        bool changed = style::fitValueAxes(*rect, font());
        QCPAxis* const below = rect->axis(QCPAxis::atBottom);
        const int count = std::clamp(rect->width() / room, least, most);
        if (below->ticker()->tickCount() != count) {
            below->ticker()->setTickCount(count);
            changed = true;
        }
        if (changed) {
            replot(rpQueuedReplot);
        }
    }
    noteLeastSize();
}

void ComparePlot::noteLeastSize() {
    QSize least(0, 0);
    for (const QCPAxisRect* rect : m_rects) {
        const QMargins around = rect->margins();
        least = {std::max(least.width(), around.left() + legiblePlot.width() + around.right()),
                 least.height() + around.top() + legiblePlot.height() + around.bottom()};
    }
    if (least != m_leastSize) {
        m_leastSize = least;
        updateGeometry();
    }
}

QCPAxis* ComparePlot::axisOf(Quantity quantity) const {
    const std::array<Quantity, 4> all = quantities();
    const auto index = static_cast<std::size_t>(std::ranges::find(all, quantity) - all.begin());
    return m_rects.at(index / 2)->axis(index % 2 == 0 ? QCPAxis::atLeft : QCPAxis::atRight);
}

void ComparePlot::setSecond(std::size_t row, Quantity quantity) {
    const bool all = visibleRange() == m_fitted;
    m_chart.setSecond(row, quantity);
    fill();
    fitValues(quantity);
    m_fitted = all ? visibleRange() : m_fitted;
    setTexts();
    emit contentChanged();
}

bool ComparePlot::setRuns(std::vector<ComparedFeeds> runs) {
    const bool all = m_fitted.empty() || visibleRange() == m_fitted;
    const QString axis = m_chart.timeLabel();
    m_chart.setRuns(std::move(runs));
    fill();
    const bool isOtherUnit = m_chart.timeLabel() != axis; // of the visible range
    if (isOtherUnit) {
        m_hairLine->setAt({});
    }
    if (all || isOtherUnit) {
        fit();
    }
    setTexts();
    setMoment(m_moment_s);
    emit contentChanged();
    return isOtherUnit;
}

void ComparePlot::setAxis(CycleAxis axis) {
    m_chart.setAxis(axis);
    m_hairLine->setAt({});
    fill();
    fit();
    setTexts();
    setMoment(m_moment_s);
}

void ComparePlot::fill() {
    clearGraphs();
    m_curves.clear();
    for (std::size_t run = runs().size(); run-- > 0;) { // the current one on top
        for (const Quantity quantity : quantities()) {
            QCPAxis* const value = axisOf(quantity);
            QCPGraph* const graph = addGraph(value->axisRect()->axis(QCPAxis::atBottom), value);
            QVector<QCPGraphData> points;
            for (const XY& p : m_chart.line(run, quantity)) {
                points.append({p.x, p.y});
            }
            graph->data()->set(points, true);
            m_curves.push_back({run, quantity, graph});
        }
    }
    showChoice();
    restyle();
}

void ComparePlot::showChoice() {
    for (const Curve& curve : m_curves) {
        curve.graph->setVisible(shows(static_cast<int>(curve.quantity))
                                && shows(runKey + runs()[curve.run].number));
    }
}

/// The other quantities, or the other runs.
LegendEntries ComparePlot::besides(int key) const {
    LegendEntries alike = legendEntries();
    std::erase_if(
        alike, [key](const LegendEntry& entry) { return (entry.key < runKey) != (key < runKey); });
    return alike;
}

void ComparePlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s && !runs().empty() ? std::optional(m_chart.scale(0).at(*time_s))
                                                  : std::nullopt);
}

// --- what is visible ---------------------------------------------------------------------------

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
    style::setSafeRange(*m_rects[0]->axis(QCPAxis::atBottom), 0, m_chart.end());
    style::setSafeRange(*m_rects[1]->axis(QCPAxis::atBottom), 0, m_chart.end());
    for (const Quantity quantity : quantities()) {
        fitValues(quantity);
    }
    m_fitted = visibleRange();
}

QList<QCPAxis*> ComparePlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

QCPGraph* ComparePlot::curve(int number, Quantity quantity) const {
    for (const Curve& curve : m_curves) {
        if (runs()[curve.run].number == number && curve.quantity == quantity) {
            return curve.graph;
        }
    }
    return nullptr;
}

// --- the mouse ----------------------------------------------------------------------------------

void ComparePlot::onMouse(QMouseEvent* event) {
    const QCPAxisRect* const rect = axisRectAt(event->pos());
    if (event->buttons() != Qt::NoButton || runs().empty()) {
        return;
    }
    if (!rect || !rect->rect().contains(event->pos())) {
        pointAway();
        return;
    }
    const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
    m_hairLine->setAt(x);
    QStringList lines{m_chart.valuesAt(0, x)};
    const Curve* const nearest = nearestCurve(event->pos());
    const std::size_t other = nearest && nearest->run > 0 ? nearest->run : runs().size() - 1;
    if (other > 0) {
        lines << m_chart.valuesAt(other, x);
    }
    emit pointed(lines.join(u'\n'));
}

/// The visible curve of another run that passes nearest, above or below.
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

// --- look and words -----------------------------------------------------------------------------

void ComparePlot::restyle() {
    ViewPlot::restyle();
    const int half = QFontMetrics(font()).height() / 2; // half the height of an axis number
    m_rects[0]->setMinimumMargins(QMargins(0, half, 0, half));
    m_rects[1]->setMinimumMargins(QMargins(0, half, 0, 0));
    for (const Quantity quantity : quantities()) { // an axis has the colour of its curves
        const QColor colour = style::colour(style::drawnAs(quantity), palette());
        axisOf(quantity)->setLabelColor(colour);
        axisOf(quantity)->setTickLabelColor(colour);
    }
    for (const Curve& curve : m_curves) {
        QPen pen = runPen(runs()[curve.run].number, toned(style::drawnAs(curve.quantity)));
        pen.setWidthF(pen.widthF() * weightOf(curve.quantity));
        curve.graph->setPen(pen);
    }
}

/// The dash identifies the run, so in black and white the width identifies the axis.
double ComparePlot::weightOf(Quantity quantity) const {
    constexpr double left = 1.3, right = 0.7;
    const bool isSecond = quantity == second(0) || quantity == second(1);
    return isSecond ? right : left;
}

void ComparePlot::setTexts() {
    for (const Quantity quantity : quantities()) {
        axisOf(quantity)->setLabel(CompareChart::briefName(quantity));
    }
    m_rects[1]->axis(QCPAxis::atBottom)->setLabel(m_chart.timeLabel());
}

LegendEntries ComparePlot::legendEntries() const {
    LegendEntries entries;
    for (const Quantity quantity : quantities()) {
        const int key = static_cast<int>(quantity);
        QPen pen = runPen(0, toned(style::drawnAs(quantity)));
        pen.setWidthF(pen.widthF() * weightOf(quantity));
        entries.push_back(lineEntry(key, pen, quantityName(quantity)));
    }
    for (const ComparedFeeds& run : runs()) {
        const int key = runKey + run.number;
        // A neutral colour, since the entry shows the dash.
        entries.push_back({palette().color(QPalette::PlaceholderText), Qt::SolidLine, run.name, key,
                           shows(key), runDash(run.number)});
    }
    return entries;
}

ReadCurves ComparePlot::readCurves() const {
    ReadCurves curves;
    const QStringList names = m_chart.shortNames();
    for (std::size_t run = 0; run < runs().size(); ++run) {
        for (const Curve& curve : m_curves) {
            if (curve.run == run && curve.graph->visible()) {
                curves.push_back({names[static_cast<qsizetype>(run)],
                                  quantityWithUnit(curve.quantity), quantityDigits(curve.quantity),
                                  [graph = curve.graph](double x) { return valueAt(*graph, x); }});
            }
        }
    }
    return curves;
}

CursorSubject ComparePlot::cursorSubject() {
    CursorSubject subject = ViewPlot::cursorSubject();
    const auto scale = [this] { return runs().empty() ? CycleScale() : m_chart.scale(0); };
    subject.keep = [scale](double x) { return scale().time_s(x); };
    subject.place = [scale](double time_s) { return scale().at(time_s); };
    return subject;
}

CsvTable ComparePlot::table() const {
    const QCPRange visible = m_rects[0]->axis(QCPAxis::atBottom)->range();
    return m_chart.table(
        visible.lower, visible.upper,
        [this](const ComparedFeeds& run) { return shows(runKey + run.number); },
        [this](Quantity quantity) { return shows(static_cast<int>(quantity)); });
}

} // namespace sparkout
