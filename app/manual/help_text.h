// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <string>

namespace sparkout::manual {

/// What `--help` prints, in English.
[[nodiscard]] std::string helpText(const Program& program);

} // namespace sparkout::manual
