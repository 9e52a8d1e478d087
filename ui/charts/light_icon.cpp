// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/light_icon.h"

#include "ui/kit/metrics.h"
#include "ui/plot/quantity_colour.h"

#include <QAbstractItemView>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QPolygonF>

#include <algorithm>

namespace sparkout {

QColor lightColour(Light light, const QPalette& palette) {
    switch (light) {
    case Light::holds: return style::colour(style::Drawn::holds, palette);
    case Light::close:
    case Light::undecided: return style::colour(style::Drawn::close, palette);
    case Light::fails: break;
    }
    return style::colour(style::Drawn::fails, palette);
}

namespace {

void paintLight(QPainter& painter, Light light, const QRectF& box) {
    switch (light) {
    case Light::holds: painter.drawEllipse(box); break;
    case Light::close:
    case Light::undecided:
        painter.drawPolygon(
            QPolygonF({QPointF(box.center().x(), box.top()), box.bottomRight(), box.bottomLeft()}));
        break;
    case Light::fails: painter.drawRect(box.adjusted(1, 1, -1, -1)); break;
    }
}

} // namespace

namespace {

/// Draws once for each key, into a square of this size.
template <class Draw>
QPixmap keptPixmap(const QString& key, int size, qreal ratio, bool grey, Draw draw) {
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = QPixmap(QSize(size, size) * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setOpacity(grey ? 0.4 : 1);
        draw(painter);
        painter.end();
        QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
}

} // namespace

QPixmap lightPixmap(Light light, int size, qreal ratio, bool grey) {
    const QColor colour = lightColour(light, QGuiApplication::palette());
    // Qt caches drawings of an icon by the identity of its picture, so a new one for every result
    // would fill the cache.
    const QString key = QStringLiteral("sparkout-light %1 %2 %3 %4 %5")
                            .arg(int(light))
                            .arg(size)
                            .arg(ratio)
                            .arg(grey)
                            .arg(colour.rgb());
    return keptPixmap(key, size, ratio, grey, [&](QPainter& painter) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        paintLight(painter, light, QRectF(1, 1, size - 2, size - 2));
    });
}

QPixmap judgedPixmap(JudgedState state, int size, qreal ratio, bool grey) {
    const bool isDashed = state == JudgedState::nominal || state == JudgedState::batchNotRun;
    if (!isDashed && state != JudgedState::notComputed) {
        const bool isOpen = state == JudgedState::undecided || state == JudgedState::measuredDiffer;
        return lightPixmap(isFailure(state)              ? Light::fails
                           : isOpen                      ? Light::undecided
                           : state == JudgedState::close ? Light::close
                                                         : Light::holds,
                           size, ratio, grey);
    }
    const QPalette palette = QGuiApplication::palette();
    const QColor colour =
        isDashed ? lightColour(Light::holds, palette) : palette.color(QPalette::PlaceholderText);
    const QString key = QStringLiteral("sparkout-ring %1 %2 %3 %4 %5")
                            .arg(isDashed)
                            .arg(size)
                            .arg(ratio)
                            .arg(grey)
                            .arg(colour.rgb());
    return keptPixmap(key, size, ratio, grey, [&](QPainter& painter) {
        QPen pen(colour, isDashed ? 2 : 1);
        if (isDashed) {
            pen.setDashPattern({1.5, 1});
        }
        painter.setPen(pen);
        painter.drawEllipse(QRectF(2, 2, size - 4, size - 4));
    });
}

namespace {

QPixmap lightOnLine(Light light, int size, int line, qreal ratio, bool grey) {
    const QPixmap drawn = lightPixmap(light, size, ratio, grey);
    const QString key =
        QStringLiteral("sparkout-light-on-line %1 %2").arg(drawn.cacheKey()).arg(line);
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = QPixmap(QSize(size, std::max(size, line)) * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.drawPixmap(QPointF(0, std::max(0, line - size) / 2.0), drawn);
        painter.end();
        QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
}

} // namespace

LightIcons lightIcons(QAbstractItemView& table, bool grey) {
    constexpr int size = metrics::iconSmall;
    const int line = std::max(size, table.fontMetrics().height());
    table.setIconSize({size, line});
    LightIcons icons;
    for (const Light light : {Light::holds, Light::close, Light::undecided, Light::fails}) {
        icons[static_cast<std::size_t>(light)] =
            QIcon(lightOnLine(light, size, line, table.devicePixelRatioF(), grey));
    }
    return icons;
}

} // namespace sparkout
