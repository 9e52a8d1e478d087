// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <cstddef>
#include <string>

namespace sparkout::manual {

/// The output of `--help` in English, for the whole program or one of its commands.
[[nodiscard]] std::string helpText(const Program& program, const Command& command);

/// The usage of the command, or of all below it: a line for each, wrapped at the width.
[[nodiscard]] std::string usageLines(const Program& program, const Command& command,
                                     std::size_t width, const std::string& indent = {});

} // namespace sparkout::manual
