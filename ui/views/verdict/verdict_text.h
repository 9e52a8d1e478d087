// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <QString>

/// The sentences of the verdict, plain text.
namespace sparkout::verdict {

[[nodiscard]] QString time(const SimulationResult& result);   ///< "2.41 min (144.6 s)"
[[nodiscard]] QString status(const SimulationResult& result); ///< with what is short of the size

} // namespace sparkout::verdict
