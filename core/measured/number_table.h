// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/tables/table_text.h"

#include <array>
#include <cstddef>
#include <string>
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

/// A table of numbers only, in either dialect, with or without headings.
template <std::size_t columns>
struct NumberTable {
    struct Row {
        std::size_t line = 0;
        std::array<double, columns> values{};
    };
    std::vector<std::string> headings; ///< none, or one a column
    std::vector<Row> rows;
    CellFaults faults; ///< cells that are not numbers, and rows with too few
};

/// Further columns and empty lines are ignored.
template <std::size_t columns>
[[nodiscard]] NumberTable<columns> readNumbers(const TableText& text);

extern template NumberTable<2> readNumbers<2>(const TableText& text);
extern template NumberTable<3> readNumbers<3>(const TableText& text);

/// Adds a fault unless the list is full.
void addFault(CellFaults& faults, std::size_t line, std::size_t column, IssueCode code,
              Detail value, Detail limit);

} // namespace sparkout
