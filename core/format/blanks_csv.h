// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"
#include "core/tables/table_text.h"

#include <string>
#include <variant>
#include <vector>

/// Measured blanks as a table: a line of headings, then a line a blank.
namespace sparkout {

/// What was measured of the blanks, in the order of the lines.
struct MeasuredColumn {
    FactorKind kind;
    std::vector<double> values;
};

/// The first thing in the table that cannot be read.
struct TableFault {
    int line = 0;     ///< from 1
    std::string text; ///< what stands there; empty where a heading of a factor is missing
};

/// Columns headed by the key of a factor ("stock_mm"); others are left out, and so are empty cells.
/// Comma, semicolon or tab separates; decimal points and commas are both understood. A row has no
/// more cells than there are headings.
[[nodiscard]] std::variant<std::vector<MeasuredColumn>, TableFault>
readMeasuredBlanks(const TableText& csv);

/// Puts measured values in place of the laws of their factors.
void putMeasured(const std::vector<MeasuredColumn>& columns, Batch& batch);

} // namespace sparkout
