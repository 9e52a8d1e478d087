// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// A fault of a table: the issue and its cell.
struct CellFault {
    std::size_t line = 0;   ///< counted from 1; 0: the whole text
    std::size_t column = 0; ///< counted from 1; 0: the whole line
    Issue issue;            ///< the issue, without a path
    friend bool operator==(const CellFault&, const CellFault&) = default;
};

using CellFaults = std::vector<CellFault>;

} // namespace sparkout
