// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/framed_plot.h"

#include "ui/plot/plot_style.h"

namespace sparkout {

PlotHistory::State FramedPlot::visibleRange() const {
    return m_frame
               ? PlotHistory::State{m_frame->x(), m_frame->y(), m_frame->width(), m_frame->height()}
               : PlotHistory::State();
}

void FramedPlot::setVisibleRange(const PlotHistory::State& range) {
    m_frame = range.size() == 4 ? std::optional(QRectF(range[0], range[1], range[2], range[3]))
                                : std::nullopt;
}

void FramedPlot::followMoves(QCPAxisRect& rect) {
    for (QCPAxis* axis : style::axesOf(rect)) {
        connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this, [this, &rect] {
            if (!m_setting) {
                const QCPRange x = rect.axis(QCPAxis::atBottom)->range();
                const QCPRange y = rect.axis(QCPAxis::atLeft)->range();
                m_frame = QRectF(x.lower, y.lower, x.size(), y.size());
            }
        });
    }
}

void FramedPlot::setRanges(const QCPAxisRect& rect, const QCPRange& x, const QCPRange& y) {
    m_setting = true;
    style::setSafeRange(*rect.axis(QCPAxis::atBottom), x.lower, x.upper);
    style::setSafeRange(*rect.axis(QCPAxis::atLeft), y.lower, y.upper);
    m_setting = false;
}

void FramedPlot::showAround(const QCPAxisRect& rect, const QPointF& centre, double perPixel) {
    const double dx = rect.width() * perPixel / 2, dy = rect.height() * perPixel / 2;
    setRanges(rect, {centre.x() - dx, centre.x() + dx}, {centre.y() - dy, centre.y() + dy});
}

} // namespace sparkout
