// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/measured_table.h"

#include "core/measured/key_value_lines.h"
#include "core/measured/measured_rows.h"
#include "core/tables/table_cell.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Counts from 0 if one of the first parts has the place 0.
int firstPlaceIn(std::string_view text, const MeasuredTable& table) {
    const auto column =
        std::ranges::find(table.columns, ColumnQuantity::place, &ColumnMatch::quantity);
    if (column == table.columns.end()) {
        return 1;
    }
    constexpr int rowsLookedAt = 1000;
    const auto index = static_cast<std::size_t>(column - table.columns.begin());
    TableReader rows(text, table.dialect.delimiter);
    (void)rows.next(); // the headings
    for (int i = 0; i < rowsLookedAt && rows.next(); ++i) {
        if (index < rows.cells().size()
            && cellNumber(rows.cells()[index], table.dialect.decimal) == 0.0) {
            return 0;
        }
    }
    return 1;
}

} // namespace

MeasuredTable proposeTable(const TableText& source) {
    const std::string_view text = source.utf8();
    MeasuredTable table;
    table.dialect = dialectOf(text);
    if (table.dialect.delimiter == '|') {
        table.isKeyValue = true;
        table.columns = matchKeys(text);
        return table;
    }
    table.columns = matchHeadings(text, table.dialect.delimiter);
    table.firstPlace = firstPlaceIn(text, table);
    return table;
}

ReadMeasured readMeasured(const TableText& source, const MeasuredTable& table,
                          const MeasuredContext& context, const std::stop_token& stop) {
    ReadMeasured read;
    const auto refuse = [&read](IssueCode code, Detail value, Detail limit) {
        read.faults.push_back(
            {0, 0, {code, Severity::error, {}, std::move(value), std::move(limit)}});
    };
    if (source.isBlank()) {
        refuse(IssueCode::empty, {}, {});
        return read;
    }
    if (source.bytes() > limits::measuredBytes) {
        refuse(IssueCode::tooLarge, countOf(source.bytes(), "bytes"),
               countOf(limits::measuredBytes, "bytes"));
        return read;
    }
    const std::string_view text = source.utf8();
    read = table.isKeyValue ? readKeyValueLines(text, table, context, stop)
                            : readRows(text, table, context, stop);
    if (stop.stop_requested()) {
        return {};
    }
    const std::string digest = read.data.traces.empty() ? std::string() : source.sha256();
    for (MeasuredTrace& trace : read.data.traces) {
        trace.source_sha256 = digest;
    }
    const Measured& data = read.data;
    if (read.faults.empty() && data.parts.empty() && data.traces.empty()) {
        refuse(IssueCode::empty, {}, {});
    }
    return read;
}

} // namespace sparkout
