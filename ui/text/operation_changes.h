// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QStringList>

namespace sparkout {

/// The changes of another operation to inputs outside the stages, and the axial feeds that it gives
/// them: "Ground length L_p: 100 mm → 50 mm", "Axial feed: not used → 1800 mm/min, 300 mm/min".
[[nodiscard]] QStringList changesOfOperation(const Project& before, const Project& after);

} // namespace sparkout
