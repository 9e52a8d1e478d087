// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/light_icon.h"

#include "ui/theme.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPolygonF>

namespace sparkout {

QPixmap lightPixmap(Light light, int size, qreal ratio, bool grey) {
    QPixmap pixmap(QSize(size, size) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    const QPalette palette = QGuiApplication::palette();
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setOpacity(grey ? 0.4 : 1);
    const QRectF box(1, 1, size - 2, size - 2);
    switch (light) {
    case Light::holds:
        painter.setBrush(tone(Tone::green, palette));
        painter.drawEllipse(box);
        break;
    case Light::close:
        painter.setBrush(tone(Tone::orange, palette));
        painter.drawPolygon(
            QPolygonF({QPointF(box.center().x(), box.top()), box.bottomRight(), box.bottomLeft()}));
        break;
    case Light::fails:
        painter.setBrush(tone(Tone::vermilion, palette));
        painter.drawRect(box.adjusted(1, 1, -1, -1));
        break;
    }
    return pixmap;
}

} // namespace sparkout
