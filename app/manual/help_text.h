// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <cstddef>
#include <string>

namespace sparkout::manual {

/// What `--help` prints in English, of the whole program or of a command of it.
[[nodiscard]] std::string helpText(const Program& program, const Command& command);

/// The command, or all below it, as typed, a line each that is broken at the width.
[[nodiscard]] std::string usageLines(const Program& program, const Command& command,
                                     std::size_t width, const std::string& indent = {});

} // namespace sparkout::manual
