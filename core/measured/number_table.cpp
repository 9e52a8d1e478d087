// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/number_table.h"

#include "core/measured/table_text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace sparkout {

void addFault(CellFaults& faults, std::size_t line, std::size_t column, IssueCode code,
              Detail value, Detail limit) {
    if (faults.size() < limits::issues) {
        faults.push_back(
            {line, column, {code, Severity::error, {}, std::move(value), std::move(limit)}});
    }
}

template <std::size_t columns>
NumberTable<columns> readNumbers(std::string_view text) {
    NumberTable<columns> table;
    const TableDialect dialect = dialectOf(text);
    TableLines lines(text);
    std::vector<std::string_view> cells;
    bool isFirst = true;
    while (!lines.atEnd()) {
        const std::string_view line = lines.next();
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
            continue;
        }
        splitCells(line, dialect.delimiter, cells);
        const bool mayBeHeadings = std::exchange(isFirst, false);
        if (cells.size() < columns) {
            addFault(table.faults, lines.number(), 0, IssueCode::wrongCount, countOf(cells.size()),
                     countOf(columns));
            continue;
        }
        cells.resize(columns);
        std::array<std::optional<double>, columns> values;
        std::ranges::transform(cells, values.begin(), [&](std::string_view cell) {
            return cellNumber(cell, dialect.decimal);
        });
        if (mayBeHeadings && std::ranges::none_of(values, [](auto v) { return v.has_value(); })) {
            table.headings.assign(cells.begin(), cells.end());
            continue;
        }
        typename NumberTable<columns>::Row row;
        row.line = lines.number();
        bool isWhole = true;
        for (std::size_t c = 0; c < columns; ++c) {
            if (values[c]) {
                row.values[c] = *values[c];
            } else {
                isWhole = false;
                addFault(table.faults, row.line, c + 1, IssueCode::wrongType, quotedCell(cells[c]),
                         Phrase::number);
            }
        }
        if (isWhole) {
            table.rows.push_back(row);
        }
    }
    return table;
}

template NumberTable<2> readNumbers<2>(std::string_view text);
template NumberTable<3> readNumbers<3>(std::string_view text);

} // namespace sparkout
