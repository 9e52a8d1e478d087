// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/framed_plot.h"

#include "ui/chart/view_plot.h"

#include <QEvent>

#include <utility>

namespace sparkout {

void ProfilePlot::setHidden(ProfileLines hidden) {
    m_hidden = std::move(hidden);
    showChoice();
}

LegendEntries ProfilePlot::entriesOf(const std::vector<ProfileLine>& lines) const {
    LegendEntries entries;
    for (const ProfileLine line : lines) {
        const bool swatch = line == ProfileLine::spread || line == ProfileLine::field;
        const QPen pen = ProfileLook::pen(line, palette(), isDimmed());
        LegendEntry entry;
        entry.colour = swatch ? ProfileLook::fill(line, palette(), isDimmed()) : pen.color();
        entry.pen = swatch ? Qt::NoPen : pen.style();
        entry.text = ProfileLook::name(line);
        entry.key = static_cast<int>(line);
        entry.shown = visible(line);
        entries.push_back(entry);
    }
    return entries;
}

void ProfilePlot::changeEvent(QEvent* event) {
    ViewPlot::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        keepLegible();
    }
}

QSize ProfilePlot::sizeFor(int plotHeight, int textLines) const {
    constexpr int leastWidth = 200;
    return {leastWidth, plotHeight + textLines * fontMetrics().lineSpacing()};
}

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
