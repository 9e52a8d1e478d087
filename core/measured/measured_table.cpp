// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/measured_table.h"

#include "core/measured/key_value_lines.h"
#include "core/measured/measured_rows.h"
#include "core/sha256.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Counted from 0, if one of the first parts names the place 0.
int firstPlaceIn(std::string_view text, const MeasuredTable& table) {
    const auto column =
        std::ranges::find(table.columns, ColumnQuantity::place, &ColumnMatch::quantity);
    if (column == table.columns.end()) {
        return 1;
    }
    constexpr int linesLookedAt = 1000;
    const auto index = static_cast<std::size_t>(column - table.columns.begin());
    TableLines lines(text);
    (void)lines.next(); // the headings
    std::vector<std::string_view> cells;
    for (int i = 0; i < linesLookedAt && !lines.atEnd(); ++i) {
        splitCells(lines.next(), table.dialect.delimiter, cells);
        if (index < cells.size() && cellNumber(cells[index], table.dialect.decimal) == 0.0) {
            return 0;
        }
    }
    return 1;
}

bool isBlank(std::string_view text) {
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

} // namespace

MeasuredTable proposeTable(std::string_view text) {
    MeasuredTable table;
    table.dialect = dialectOf(text);
    if (table.dialect.delimiter == '|') {
        table.isKeyValue = true;
        table.columns = matchKeys(text);
        return table;
    }
    std::vector<std::string_view> cells;
    TableLines lines(text);
    splitCells(lines.next(), table.dialect.delimiter, cells);
    for (const std::string_view cell : cells) {
        table.columns.push_back(matchHeading(cell));
    }
    settleMatches(table.columns);
    table.firstPlace = firstPlaceIn(text, table);
    return table;
}

ReadMeasured readMeasured(std::string_view text, const MeasuredTable& table,
                          const MeasuredContext& context, const std::stop_token& stop) {
    ReadMeasured read;
    const auto refuse = [&read](IssueCode code, Detail value, Detail limit) {
        read.faults.push_back(
            {0, 0, {code, Severity::error, {}, std::move(value), std::move(limit)}});
    };
    if (isBlank(text)) {
        refuse(IssueCode::empty, {}, {});
        return read;
    }
    if (text.size() > limits::measuredBytes) {
        refuse(IssueCode::tooLarge, countOf(text.size(), "bytes"),
               countOf(limits::measuredBytes, "bytes"));
        return read;
    }
    read = table.isKeyValue ? readKeyValueLines(text, table, context, stop)
                            : readRows(text, table, context, stop);
    if (stop.stop_requested()) {
        return {};
    }
    const std::string digest = read.data.traces.empty() ? std::string() : sha256(text);
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
