// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <cstddef>
#include <string>

/// The texts that are made of the rows of command_line.h.
namespace sparkout::manual {

/// The output of `--help` in English, for the whole program or one of its commands.
[[nodiscard]] std::string helpText(const Program& program, const Command& command);

/// The usage of the command, or of all below it: a line for each, wrapped at the width.
[[nodiscard]] std::string usageLines(const Program& program, const Command& command,
                                     std::size_t width, const std::string& indent = {});

/// The manual page of a program in section 1, as roff in UTF-8.
[[nodiscard]] std::string manualPage(const Program& program, Tongue tongue,
                                     const std::string& version);

/// How a shell completes the command line of a program.
[[nodiscard]] std::string bashCompletion(const Program& program);
[[nodiscard]] std::string zshCompletion(const Program& program);
[[nodiscard]] std::string fishCompletion(const Program& program);

} // namespace sparkout::manual
