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

} // namespace sparkout
