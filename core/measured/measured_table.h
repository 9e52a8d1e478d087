// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/cell_fault.h"
#include "core/measured/column_match.h"
#include "core/project/measured.h"
#include "core/tables/table_reader.h"
#include "core/tables/table_text.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

/// Measured parts and traces as a table: a file, or what was pasted from a spreadsheet.
namespace sparkout {

namespace limits {
inline constexpr std::size_t measuredBytes = 256U << 20; ///< of the file
} // namespace limits

/// How a table is to be read: proposed from its text, for the user to change.
struct MeasuredTable {
    TableDialect dialect;
    bool isKeyValue = false;          ///< lines time|key|value instead of a line of headings
    std::vector<ColumnMatch> columns; ///< of key-value lines one for each key
    int firstPlace = 0; ///< what zones and sections are counted from in the table: 0 or 1
    friend bool operator==(const MeasuredTable&, const MeasuredTable&) = default;
};

[[nodiscard]] MeasuredTable proposeTable(const TableText& source);

/// What the table cannot say itself.
struct MeasuredContext {
    std::string source;            ///< name of the file; empty: pasted
    double nominalDiameter_mm = 0; ///< which deviations are from
    double currentFactor_kw_a = 0; ///< of a spindle current; 0: not known
};

struct ReadMeasured {
    Measured data;
    CellFaults faults;    ///< at most limits::issues; with any the data are not complete
    std::size_t rows = 0; ///< lines of values
};

/// Reads a table as it was matched. Empty cells are left out. Traces are thinned out to what a
/// project keeps. A stop leaves nothing.
[[nodiscard]] ReadMeasured readMeasured(const TableText& source, const MeasuredTable& table,
                                        const MeasuredContext& context,
                                        const std::stop_token& stop = {});

} // namespace sparkout
