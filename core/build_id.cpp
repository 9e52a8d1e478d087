// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build_id.h"

#include "core/build_flags.h"
#include "core/source_digest.h"

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

namespace sparkout {

namespace {

std::string compiler() {
#if defined(__clang__)
    return std::string("Clang ") + __clang_version__;
#else
    return std::string("GCC ") + __VERSION__;
#endif
}

/// The version at run time, which may differ from that at compile time.
std::string libraryOfC() {
#if defined(__GLIBC__)
    return std::string("glibc ") + gnu_get_libc_version();
#else
    return "another C library";
#endif
}

} // namespace

std::string buildId() {
    return std::string(SPARKOUT_SOURCE_DIGEST) + ", " + compiler() + ", " + libraryOfC() + ", "
           + SPARKOUT_BUILD_FLAGS;
}

} // namespace sparkout
