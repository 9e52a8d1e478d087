// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/cycle_plot.h"

#include "ui/plot/painted_layer.h"
#include "ui/plot/plot_cursors.h"

#include <QMouseEvent>

#include <algorithm>

namespace sparkout {

namespace {
constexpr double leastTimes = 1e-6; ///< narrowest visible range, as a share of the cycle
}

CyclePlot::CyclePlot(QWidget* parent)
    : ChartPlot(parent)
    , m_momentLine(new HairLine(*this, HairLine::Role::moment))
    , m_hairLine(new HairLine(*this)) {
    setPlottingHints(QCP::phFastPolylines);
    setMouseTracking(true);
    onClick([this](const QPointF& at) {
        if (const auto place = placeAt(at)) {
            emit timeClicked(times().scale.time_s(place->x));
        }
    });
}

void CyclePlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s ? std::optional(times().scale.at(*time_s)) : std::nullopt);
}

// --- the visible times --------------------------------------------------------------------------

void CyclePlot::follow() {
    m_isFollowing = true;
    takeCharts();
    if (const CycleTimes& of = times(); cellCount() > 0 && of.to_s > of.from_s) {
        style::setSafeRange(across(), of.scale.at(of.from_s), of.scale.at(of.to_s));
    }
    fitValues();
    m_isFollowing = false;
    if (timeLabel() != m_label) { // another unit
        m_label = timeLabel();
        m_hairLine->setAt({});
    }
    setMoment(m_moment_s);
}

void CyclePlot::cellsBuilt() {
    if (cellCount() > 0) { // the axes of the other cells follow
        connect(&across(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                &CyclePlot::onTimesChanged);
    }
}

void CyclePlot::onTimesChanged(const QCPRange& range) {
    if (m_isFollowing) {
        return;
    }
    const CycleTimes& of = times();
    const double end = of.scale.at(of.end_s);
    const double size = std::clamp(range.size(), end * leastTimes, end);
    const double low = std::clamp(range.lower, 0.0, end - size);
    emit timesWanted(of.scale.time_s(low), of.scale.time_s(low + size));
}

void CyclePlot::showChoice() {
    follow();
}

QList<QCPAxis*> CyclePlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- reading ------------------------------------------------------------------------------------

CursorSubject CyclePlot::cursorSubject() {
    return {[this] { return timeLabel(); },
            [this] { return QCPRange(0, times().scale.at(times().end_s)); },
            [this] { return readCurves(); }, [this](double x) { return times().scale.time_s(x); },
            [this](double time_s) { return times().scale.at(time_s); }};
}

void CyclePlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    const auto place = placeAt(event->position());
    m_hairLine->setAt(place ? std::optional(place->x) : std::nullopt);
    const BandLayer* const layer = place ? bands(*cellAt(event->position())) : nullptr;
    const Band* const band = layer ? layer->bandAt(place->x) : nullptr;
    setToolTip(band ? band->meaning : QString());
    ViewPlot::onMouse(event);
}

void CyclePlot::pointAway() {
    m_hairLine->setAt({});
    setToolTip({});
    ViewPlot::pointAway();
}

} // namespace sparkout
