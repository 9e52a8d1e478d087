// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/surface_status.h"

#include <QIcon>
#include <QString>

namespace sparkout {

/// The headline of its judgement; "inputs refused", "not run".
[[nodiscard]] QString statusText(const SurfaceStatus& status);

/// The requirement to report first, with its margin: "Roundness +1.2 µm"; empty: not run.
[[nodiscard]] QString worstText(const SurfaceStatus& status);

/// The mark of its judgement: a ring if it was not run, a cross for refused inputs.
[[nodiscard]] QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio);

} // namespace sparkout
