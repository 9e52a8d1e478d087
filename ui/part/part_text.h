// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "ui/session/part_runs.h"

#include <QIcon>
#include <QString>

#include <optional>

namespace sparkout {

/// The times of a part with their formulas and numbers, one per line.
[[nodiscard]] QString pieceTimeText(const SetupTimes& times, std::size_t surfaces,
                                    std::optional<double> cycles_min);

/// The headline of its judgement; "inputs refused", "not run".
[[nodiscard]] QString statusText(const SurfaceStatus& status);

/// The requirement to report first, with its margin: "Roundness +1.2 µm"; empty: not run.
[[nodiscard]] QString worstText(const SurfaceStatus& status);

/// The mark of its judgement: a ring if it was not run, a cross for refused inputs.
[[nodiscard]] QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio);

} // namespace sparkout
