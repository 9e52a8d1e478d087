// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/feeds_plot.h"

#include "ui/plot/band_layer.h"
#include "ui/plot/feed_text.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/plot_click.h"
#include "ui/plot/plot_style.h"

#include <algorithm>

namespace sparkout {

FeedsPlot::FeedsPlot(QWidget* parent) : ViewPlot(parent) {
    setPlottingHints(QCP::phFastPolylines);
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    plotLayout()->clear();
    m_momentLine = new HairLine(*this, HairLine::Role::moment);
    m_hairLine = new HairLine(*this);
    setMouseTracking(true);
    connect(this, &QCustomPlot::mouseMove, this, &FeedsPlot::onMouse);
    onPlotClick(*this, [this](const QPointF& at) {
        if (const QCPAxisRect* rect = axisRectAt(at); rect && !m_columns.empty()) {
            emit timeClicked(m_scale.time_s(rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
        }
    });
    setBuilt();
}

const FeedSeries& FeedsPlot::series() const {
    static const FeedSeries none;
    return m_outcome ? m_outcome->feeds : none;
}

const FeedColumn& FeedsPlot::source(int column) const {
    return series().columns.at(m_columns.at(static_cast<std::size_t>(column)).index);
}

void FeedsPlot::setRun(OutcomePtr outcome, const std::vector<int>& shown) {
    const bool sameGrid = m_outcome && shown.size() == m_columns.size()
                          && outcome->feeds.operation == series().operation;
    m_outcome = std::move(outcome);
    m_scale = CycleScale(series(), m_axis);
    m_strokes = CycleScale(series(), CycleAxis::strokes);
    if (!sameGrid) {
        buildGrid(shown.size());
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        m_columns[i].index = static_cast<std::size_t>(shown[i]);
    }
    if (!sameGrid) {
        retranslate();
        emit gridBuilt();
    }
    const double end_s = series().end_s;
    const bool inside = m_to_s > m_from_s && m_from_s < end_s;
    showTimes(inside ? m_from_s : 0, inside ? std::min(m_to_s, end_s) : end_s);
}

void FeedsPlot::setAxis(CycleAxis axis) {
    m_axis = axis;
    m_scale = CycleScale(series(), axis);
    m_hairLine->setAt({});
    setMoment(m_moment_s);
    labelAxes();
    showTimes(m_from_s, m_to_s);
}

void FeedsPlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s ? std::optional(m_scale.at(*time_s)) : std::nullopt);
}

void FeedsPlot::toggleCurve(int key) {
    m_choice.toggle(key);
    showCurves();
}

void FeedsPlot::showOnly(int key) {
    m_choice.only(key, legendEntries());
    showCurves();
}

// --- what is in sight ---------------------------------------------------------------------------

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
    emit timesChanged();
}

void FeedsPlot::onTimesChanged(const QCPRange& range) {
    if (m_linking) {
        return;
    }
    // Pan and zoom stay within the cycle, and wider than a thousandth of a revolution.
    const double end = m_scale.at(series().end_s);
    const double size = std::clamp(range.size(), end * 1e-6, end);
    const double low = std::clamp(range.lower, 0.0, end - size);
    showTimes(m_scale.time_s(low), m_scale.time_s(low + size));
}

void FeedsPlot::onValuesChanged(QCPAxis* axis, const QCPRange& range) {
    if (m_linking) {
        return;
    }
    m_linking = true;
    for (std::size_t row = 0; row < rowCount; ++row) {
        const bool here = std::ranges::any_of(
            m_columns, [&](const Column& c) { return c.rects[row] == axis->axisRect(); });
        if (!here) {
            continue;
        }
        for (Column& column : m_columns) {
            column.rects[row]->axis(axis->axisType())->setRange(range);
        }
        const QCPAxisRect* first = m_columns.front().rects[row];
        m_values[row] = {true, first->axis(QCPAxis::atLeft)->range(),
                         first->axis(QCPAxis::atRight)->range()};
    }
    m_linking = false;
    fitColumns();
}

PlotHistory::State FeedsPlot::sight() const {
    PlotHistory::State state{m_from_s, m_to_s};
    for (const RowValues& row : m_values) {
        const RowValues v = row.own ? row : RowValues{};
        state.insert(state.end(),
                     {v.own ? 1.0 : 0.0, v.left.lower, v.left.upper, v.right.lower, v.right.upper});
    }
    return state;
}

void FeedsPlot::setSight(const PlotHistory::State& state) {
    constexpr std::size_t perRow = 5;
    if (m_columns.empty() || state.size() != 2 + perRow * rowCount) {
        return;
    }
    m_linking = true;
    for (std::size_t row = 0; row < rowCount; ++row) {
        const double* v = state.data() + 2 + perRow * row;
        m_values[row] = {v[0] > 0, QCPRange(v[1], v[2]), QCPRange(v[3], v[4])};
        for (Column& column : m_columns) {
            if (m_values[row].own) {
                column.rects[row]->axis(QCPAxis::atLeft)->setRange(m_values[row].left);
                column.rects[row]->axis(QCPAxis::atRight)->setRange(m_values[row].right);
            }
        }
    }
    m_linking = false;
    const double end_s = series().end_s;
    const double from_s = std::min(state[0], end_s);
    const bool inside = from_s < end_s;
    showTimes(inside ? from_s : 0, inside ? std::min(state[1], end_s) : end_s);
}

QList<QCPAxis*> FeedsPlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- the mouse ----------------------------------------------------------------------------------

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
            m_hairLine->setAt(x);
            emit pointed(
                feedText(column.points, m_scale.time_s(x), series(), m_detail == Detail::stroke));
            const Band* band = column.bands[row]->bandAt(x);
            emit pointedBand(band ? band->meaning : QString());
            return;
        }
    }
    pointAway();
}

void FeedsPlot::pointAway() {
    m_hairLine->setAt({});
    ViewPlot::pointAway();
    emit pointedBand({});
}

void FeedsPlot::resizeEvent(QResizeEvent* event) {
    fitColumns();
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
