// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/blanks_csv.h"

#include "core/file/text_table.h"
#include "core/project/batch.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace sparkout {

namespace {

std::optional<FactorKind> factorOf(std::string_view heading) {
    const auto fields = tableOf<Factors>().fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (heading == fields[i].key) {
            return static_cast<FactorKind>(i);
        }
    }
    return std::nullopt;
}

/// With either decimal separator, since the delimiter is known.
std::optional<double> numberOf(std::string_view cell) {
    const auto plain = cellNumber(cell, '.');
    return plain ? plain : cellNumber(cell, ',');
}

TableFault faultAt(const TableReader& rows, std::size_t column) {
    return {static_cast<int>(rows.line()), std::string(rows.cells()[column])};
}

} // namespace

std::variant<std::vector<MeasuredColumn>, TableFault> readMeasuredBlanks(const TableText& csv) {
    TableReader rows(csv.utf8(), dialectOf(csv.utf8()).delimiter);
    std::vector<MeasuredColumn> columns;
    std::vector<std::size_t> places;
    const bool hasHeadings = rows.next();
    const std::size_t headings = rows.cells().size();
    for (std::size_t i = 0; i < headings; ++i) {
        if (const auto kind = factorOf(rows.cells()[i])) {
            if (std::ranges::find(columns, *kind, &MeasuredColumn::kind) != columns.end()) {
                return faultAt(rows, i);
            }
            columns.push_back({*kind, {}});
            places.push_back(i);
        }
    }
    if (columns.empty()) {
        return TableFault{hasHeadings ? static_cast<int>(rows.line()) : 1, {}};
    }
    while (rows.next()) {
        const std::vector<std::string_view>& cells = rows.cells();
        if (cells.size() > headings) {
            return faultAt(rows, headings);
        }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (places[c] >= cells.size() || cells[places[c]].empty()) {
                continue;
            }
            const auto value = numberOf(cells[places[c]]);
            if (!value) {
                return faultAt(rows, places[c]);
            }
            columns[c].values.push_back(*value);
        }
    }
    return columns;
}

void putMeasured(const std::vector<MeasuredColumn>& columns, Batch& batch) {
    const auto fields = tableOf<Factors>().fields;
    for (const MeasuredColumn& column : columns) {
        const Field& field = fields[static_cast<std::size_t>(column.kind)];
        auto& law = *static_cast<Factor*>(field.object(&batch.factors, true));
        law = {};
        law.measured = column.values;
    }
}

} // namespace sparkout
