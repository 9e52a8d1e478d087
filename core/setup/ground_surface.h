// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string>

namespace sparkout {

/// One surface of a set-up: the project of its cycle, which holds what all of them share too.
struct GroundSurface {
    std::string name; ///< empty in a file of one surface alone
    Project project;
};

} // namespace sparkout
