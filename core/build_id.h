// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The build of the engine: digest of its sources, the compiler, the C library at run time, whose
/// mathematical functions it calls, and the compiler options except warnings: "3f2a…, GCC 12.2.0,
/// glibc 2.36, Eigen 3.4.0, x86_64 -O2 -DNDEBUG …". Two builds with one id give the same bits on
/// the same machine.
[[nodiscard]] std::string buildId();

} // namespace sparkout
