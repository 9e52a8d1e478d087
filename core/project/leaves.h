// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string>
#include <vector>

namespace sparkout {

/// A value of a struct that holds no further rows: where it stands, its row, and the struct it is
/// a member of. Of a list of structs its number of items is a value, too.
struct Leaf {
    std::string path; ///< "/cycle/stages/0/stock_mm"
    const Field* field;
    const void* owner;
};

/// All values below a struct in the order of its table; of what is not given, the row alone.
[[nodiscard]] std::vector<Leaf> leavesOf(const StructInfo& table, const void* owner);

} // namespace sparkout
