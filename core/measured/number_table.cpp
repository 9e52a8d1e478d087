// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/number_table.h"

#include "core/tables/table_cell.h"
#include "core/tables/table_reader.h"

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
NumberTable<columns> readNumbers(const TableText& text) {
    NumberTable<columns> table;
    const TableDialect dialect = dialectOf(text.utf8());
    TableReader rows(text.utf8(), dialect.delimiter);
    bool isFirst = true;
    while (rows.next()) {
        if (rows.isBlank()) {
            continue;
        }
        std::vector<std::string_view> cells = rows.cells();
        const bool mayBeHeadings = std::exchange(isFirst, false);
        if (cells.size() < columns) {
            addFault(table.faults, rows.line(), 0, IssueCode::wrongCount, countOf(cells.size()),
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
        row.line = rows.line();
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

template NumberTable<2> readNumbers<2>(const TableText& text);
template NumberTable<3> readNumbers<3>(const TableText& text);

} // namespace sparkout
