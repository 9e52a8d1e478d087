// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <functional>

class QCustomPlot;

namespace sparkout {

/// Tells where the left button was pressed and let go without a drag between.
void onPlotClick(QCustomPlot& plot, std::function<void(const QPointF& at)> clicked);

} // namespace sparkout
