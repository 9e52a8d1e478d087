// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPen>
#include <QPixmap>

namespace sparkout {

/// The line of one of several runs: the current run, number 0, is solid; the others have different
/// dashes, and wider lines once these repeat.
[[nodiscard]] QVector<qreal> runDash(int number); ///< in pen widths; empty: solid
[[nodiscard]] QPen runPen(int number, const QColor& colour);

/// A sample of the line for a list.
[[nodiscard]] QPixmap runSample(int number, const QColor& colour, const QSize& size, qreal ratio);

} // namespace sparkout
