// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <QString>

/// The texts of the verdict, plain.
namespace sparkout::verdict {

[[nodiscard]] QString time(const SimulationResult& result);   ///< "2.41 min (144.6 s)"
[[nodiscard]] QString status(const SimulationResult& result); ///< including a shortfall of size

} // namespace sparkout::verdict
