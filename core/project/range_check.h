// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

#include <string>

namespace sparkout {

/// Checks every member against the hard and soft range of its row.
[[nodiscard]] Issues checkRanges(const Project& project);

/// Checks a struct whose rows have no conditions, at a path of its file.
[[nodiscard]] Issues checkRanges(const StructInfo& table, const void* owner,
                                 const std::string& path);

} // namespace sparkout
