// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/light.h"

#include <QColor>
#include <QPalette>
#include <QPixmap>

namespace sparkout {

[[nodiscard]] QColor lightColour(Light light, const QPalette& palette);

/// Circle, triangle or square in the light's colour of the present theme, distinct without
/// colour too.
[[nodiscard]] QPixmap lightPixmap(Light light, int size, qreal ratio, bool grey);
/// The same in the middle of a line of text so high: in a cell of several lines, at its top, it
/// stands on the first.
[[nodiscard]] QPixmap lightOnLine(Light light, int size, int line, qreal ratio, bool grey);

} // namespace sparkout
