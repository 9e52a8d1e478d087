// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string>

namespace sparkout {

/// One surface of a set-up: the project of its cycle, including what all surfaces share.
struct GroundSurface {
    std::string name; ///< empty in a file with one surface
    Project project;
};

} // namespace sparkout
