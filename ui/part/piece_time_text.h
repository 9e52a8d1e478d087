// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <QString>

#include <optional>

namespace sparkout {

/// The times of a part with their formulas and numbers, one per line.
[[nodiscard]] QString pieceTimeText(const SetupTimes& times, std::size_t surfaces,
                                    std::optional<double> cycles_min);

} // namespace sparkout
