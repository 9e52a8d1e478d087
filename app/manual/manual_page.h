// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <string>

namespace sparkout::manual {

/// The manual page of a program in section 1, as roff in UTF-8.
[[nodiscard]] std::string manualPage(const Program& program, Tongue tongue,
                                     const std::string& version);

} // namespace sparkout::manual
