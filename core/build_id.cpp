// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build_id.h"

#include "core/source_digest.h"

namespace sparkout {

std::string buildId() {
#if defined(__clang__)
    return std::string(SPARKOUT_SOURCE_DIGEST ", Clang ") + __clang_version__;
#else
    return std::string(SPARKOUT_SOURCE_DIGEST ", GCC ") + __VERSION__;
#endif
}

} // namespace sparkout
