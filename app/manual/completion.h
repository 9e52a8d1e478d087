// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <string>

namespace sparkout::manual {

/// How a shell completes the command line of a program.
[[nodiscard]] std::string bashCompletion(const Program& program);
[[nodiscard]] std::string zshCompletion(const Program& program);
[[nodiscard]] std::string fishCompletion(const Program& program);

} // namespace sparkout::manual
