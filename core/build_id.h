// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The build of the engine: digest of its sources and the compiler, "3f2a…, GCC 12.2.0". Two
/// builds of one id give the same bits on the same machine.
[[nodiscard]] std::string buildId();

} // namespace sparkout
