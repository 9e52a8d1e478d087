// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/document.h"

namespace sparkout {

struct Untitled : Document {
    explicit Untitled(const auto& begun) { startUntitled(begun); } ///< a project or a set-up
};

} // namespace sparkout
