// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPen>
#include <QPixmap>

namespace sparkout {

/// How the curves of one of several runs are drawn: the present run, number 0, solid; the others
/// with dashes of their own, and thicker ones once those are used up.
[[nodiscard]] QVector<qreal> runDash(int number); ///< in widths of the pen; empty: solid
[[nodiscard]] QPen runPen(int number, const QColor& colour);

/// A sample of it for a list.
[[nodiscard]] QPixmap runSample(int number, const QColor& colour, const QSize& size, qreal ratio);

} // namespace sparkout
