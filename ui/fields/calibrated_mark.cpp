// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/calibrated_mark.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace sparkout {

namespace {

constexpr int rulerWidth = 16, rulerHeight = 10;
constexpr int divisions = 5;

} // namespace

CalibratedMark::CalibratedMark(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setVisible(false);
}

void CalibratedMark::showCalibration(bool holds, const QString& details) {
    m_holds = holds;
    setToolTip(details);
    setAccessibleName(details.section(u'\n', 0, 0));
    setAccessibleDescription(details);
    setVisible(!details.isEmpty());
    update();
}

QSize CalibratedMark::sizeHint() const {
    return {rulerWidth, rulerHeight};
}

void CalibratedMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = tone(m_holds ? Tone::green : Tone::warning, palette());
    constexpr double line = 1.3, half = 0.5;
    painter.setPen(QPen(colour, line));
    const QRectF body = QRectF(rect()).adjusted(half, half, -half, -half);
    painter.drawRect(body);
    for (int i = 1; i < divisions; ++i) {
        const double x = body.left() + body.width() * i / divisions;
        painter.drawLine(QPointF(x, body.top()),
                         QPointF(x, body.top() + body.height() * (i % 2 == 0 ? 0.65 : 0.4)));
    }
    if (!m_holds) {
        painter.drawLine(body.bottomLeft(), body.topRight());
    }
}

} // namespace sparkout
