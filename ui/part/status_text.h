// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/surface_status.h"

#include <QIcon>
#include <QString>

namespace sparkout {

/// The headline of its judgement; "inputs refused", "not run".
[[nodiscard]] QString statusText(const SurfaceStatus& status);

/// The requirement to speak of first and its margin: "Roundness +1.2 µm"; empty: not run.
[[nodiscard]] QString worstText(const SurfaceStatus& status);

/// The mark of its judgement; what was not run has a ring, refused inputs a cross.
[[nodiscard]] QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio);

} // namespace sparkout
