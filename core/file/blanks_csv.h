// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_encoding.h"
#include "core/project/given_factors.h"

#include <string>
#include <variant>
#include <vector>

/// Measured blanks as a table: a line of headings, then a line for each blank.
namespace sparkout {

/// The measurements of the blanks, in the order of the lines.
struct MeasuredColumn {
    FactorKind kind;
    std::vector<double> values;
};

/// The first unreadable cell of the table.
struct TableFault {
    int line = 0;     ///< counted from 1
    std::string text; ///< the text found; empty if a heading of a factor is missing
};

/// Columns headed by the key of a factor ("stock_mm"); others are ignored, and so are empty cells.
/// The delimiter is comma, semicolon or tab; decimal points and commas are accepted. A row has no
/// more cells than there are headings.
[[nodiscard]] std::variant<std::vector<MeasuredColumn>, TableFault>
readMeasuredBlanks(const TableText& csv);

/// Replaces the laws of factors by measured values.
void putMeasured(const std::vector<MeasuredColumn>& columns, Batch& batch);

} // namespace sparkout
