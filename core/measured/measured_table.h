// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/column_match.h"
#include "core/measured/number_table.h"
#include "core/project/measured.h"
#include "core/tables/table_reader.h"
#include "core/tables/table_text.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

/// Measured parts and traces as a table: a file, or text pasted from a spreadsheet.
namespace sparkout {

namespace limits {
inline constexpr std::size_t measuredBytes = 256U << 20; ///< largest file that is read
} // namespace limits

/// The interpretation of a table, proposed from its text and changeable by the user.
struct MeasuredTable {
    TableDialect dialect;
    bool isKeyValue = false;          ///< lines time|key|value instead of a line of headings
    std::vector<ColumnMatch> columns; ///< for key-value lines one for each key
    int firstPlace = 0;               ///< number of the first zone or section in the table: 0 or 1
    friend bool operator==(const MeasuredTable&, const MeasuredTable&) = default;
};

[[nodiscard]] MeasuredTable proposeTable(const TableText& source);

/// Additional data that the table does not contain.
struct MeasuredContext {
    std::string source;            ///< name of the file; empty: pasted
    double nominalDiameter_mm = 0; ///< reference of deviations
    double currentFactor_kw_a = 0; ///< of a spindle current; 0: not known
};

struct ReadMeasured {
    Measured data;
    CellFaults faults;    ///< at most limits::issues; if there are any, the data are incomplete
    std::size_t rows = 0; ///< lines of values
};

/// Reads a table with its interpretation. Empty cells are skipped. Traces are thinned to the limit
/// of a project. Empty after a stop.
[[nodiscard]] ReadMeasured readMeasured(const TableText& source, const MeasuredTable& table,
                                        const MeasuredContext& context,
                                        const std::stop_token& stop = {});

} // namespace sparkout
