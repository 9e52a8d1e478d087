// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds_plot.h"

#include "ui/views/band_layer.h"
#include "ui/views/feed_text.h"
#include "ui/views/names.h"
#include "ui/views/plot_style.h"

#include <algorithm>

namespace sparkout {

FeedsPlot::FeedsPlot(QWidget* parent) : QCustomPlot(parent) {
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    setPlottingHints(QCP::phFastPolylines);
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    plotLayout()->clear();
    addLayer(QStringLiteral("bands"), layer(QStringLiteral("background")), QCustomPlot::limAbove);
    setMouseTracking(true);
    connect(this, &QCustomPlot::mouseWheel, this, &FeedsPlot::onWheel);
    connect(this, &QCustomPlot::mouseMove, this, &FeedsPlot::onMouse);
    connect(this, &QCustomPlot::mouseDoubleClick, this, &FeedsPlot::fitAsked);
}

void FeedsPlot::setRun(OutcomePtr outcome, FeedSeries series) {
    const bool sameGrid =
        series.columns.size() == m_columns.size() && series.operation == m_series.operation;
    m_outcome = std::move(outcome);
    m_series = std::move(series);
    m_scale = CycleScale(m_series, m_axis);
    m_strokes = CycleScale(m_series, CycleAxis::strokes);
    if (!sameGrid) {
        buildGrid();
    }
    fitHeaders();
    const bool inside = m_to_s > m_from_s && m_from_s < m_series.end_s;
    showTimes(inside ? m_from_s : 0, inside ? std::min(m_to_s, m_series.end_s) : m_series.end_s);
}

void FeedsPlot::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_scale = CycleScale(m_series, axis);
    labelAxes();
    showTimes(m_from_s, m_to_s);
}

void FeedsPlot::setDimmed(bool dim) {
    if (m_dim != dim) {
        m_dim = dim;
        restyle();
    }
}

void FeedsPlot::showTimes(double from_s, double to_s) {
    if (m_columns.empty() || !(to_s > from_s)) {
        return;
    }
    m_from_s = from_s;
    m_to_s = to_s;
    m_linking = true;
    for (Column& column : m_columns) {
        for (QCPAxisRect* rect : column.rects) {
            style::setSafeRange(*rect->axis(QCPAxis::atBottom), m_scale.at(from_s),
                                m_scale.at(to_s));
        }
    }
    m_linking = false;
    refresh();
}

void FeedsPlot::onTimesChanged(const QCPRange& range) {
    if (m_linking) {
        return;
    }
    // Pan and zoom stay within the cycle, and wider than a thousandth of a revolution.
    const double end = m_scale.at(m_series.end_s);
    const double size = std::clamp(range.size(), end * 1e-6, end);
    const double low = std::clamp(range.lower, 0.0, end - size);
    showTimes(m_scale.time_s(low), m_scale.time_s(low + size));
    emit movedByUser();
}

void FeedsPlot::onValuesChanged(QCPAxis* axis, const QCPRange& range) {
    if (m_linking) {
        return;
    }
    m_linking = true;
    for (std::size_t row = 0; row < rowCount; ++row) {
        const bool here = std::ranges::any_of(
            m_columns, [&](const Column& c) { return c.rects[row] == axis->axisRect(); });
        for (Column& column : m_columns) {
            if (here) {
                column.rects[row]->axis(axis->axisType())->setRange(range);
                m_ownValues[row] = true;
            }
        }
    }
    m_linking = false;
}

void FeedsPlot::onWheel(QWheelEvent* event) {
    const QPointF at = event->position();
    for (QCPAxisRect* rect : axisRects()) {
        const bool left = at.x() < rect->left();
        const bool right = at.x() > rect->right();
        QCPAxis* values = rect->axis(right ? QCPAxis::atRight : QCPAxis::atLeft);
        rect->setRangeZoomAxes(left || right ? nullptr : rect->axis(QCPAxis::atBottom),
                               left || right ? values : nullptr);
    }
}

void FeedsPlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    for (const Column& column : m_columns) {
        for (std::size_t row = 0; row < rowCount; ++row) {
            const QCPAxisRect* rect = column.rects[row];
            if (!rect->rect().contains(event->pos())) {
                continue;
            }
            const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
            const double time_s = m_scale.time_s(x);
            emit pointed(feedText(column.points, time_s, m_series, m_detail == Detail::stroke));
            const Band* band = column.bands[row]->bandAt(x);
            emit pointedBand(band ? band->meaning : QString());
            return;
        }
    }
    emit pointed({});
    emit pointedBand({});
}

void FeedsPlot::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    emit pointed({});
}

void FeedsPlot::resizeEvent(QResizeEvent* event) {
    fitHeaders();
    QCustomPlot::resizeEvent(event);
}

BandLayer* FeedsPlot::bands(int column, int row) const {
    return m_columns.at(static_cast<std::size_t>(column)).bands.at(static_cast<std::size_t>(row));
}

QCPAxisRect* FeedsPlot::cell(int column, int row) const {
    return m_columns.at(static_cast<std::size_t>(column)).rects.at(static_cast<std::size_t>(row));
}

QCPGraph* FeedsPlot::curve(int column, Quantity quantity, Edge edge) const {
    for (const Curve& c : m_columns.at(static_cast<std::size_t>(column)).curves) {
        if (c.quantity == quantity && c.edge == edge) {
            return c.graph;
        }
    }
    return nullptr;
}

} // namespace sparkout
