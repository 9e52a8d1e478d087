// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string>
#include <vector>

namespace sparkout {

/// A value of a struct without further rows: its path, its row and the struct that has it as a
/// member. For a list of structs the number of items is such a value, too.
struct Leaf {
    std::string path; ///< "/cycle/stages/0/stock_mm"
    const Field* field;
    const void* owner;
};

/// All values below a struct in the order of its table; for a struct that is not given only its
/// row.
[[nodiscard]] std::vector<Leaf> leavesOf(const StructInfo& table, const void* owner);

} // namespace sparkout
