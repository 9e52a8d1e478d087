// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_click.h"

#include <QApplication>
#include <QMouseEvent>

#include <memory>
#include <qcustomplot.h>
#include <utility>

namespace sparkout {

void onPlotClick(QCustomPlot& plot, std::function<void(const QPointF& at)> clicked) {
    auto pressed = std::make_shared<QPointF>();
    QObject::connect(&plot, &QCustomPlot::mousePress, &plot,
                     [pressed](QMouseEvent* event) { *pressed = event->position(); });
    QObject::connect(&plot, &QCustomPlot::mouseRelease, &plot,
                     [pressed, clicked = std::move(clicked)](QMouseEvent* event) {
                         const QPointF moved = event->position() - *pressed;
                         if (event->button() == Qt::LeftButton
                             && moved.manhattanLength() < QApplication::startDragDistance()) {
                             clicked(event->position());
                         }
                     });
}

} // namespace sparkout
