// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/stiffness_table.h"

#include "core/measured/column_match.h"
#include "core/units.h"

namespace sparkout {

StiffnessTable readStiffnessTable(const TableText& text) {
    NumberTable<3> table = readNumbers<3>(text);
    const auto isIn = [&table](std::size_t column, ColumnUnit unit) {
        return !table.headings.empty() && matchHeading(table.headings[column]).unit == unit;
    };
    constexpr double nPerKn = 1000;
    const double perLoad = isIn(1, ColumnUnit::kn) ? nPerKn : 1;
    const double perDeflection = isIn(2, ColumnUnit::mm) ? units::umPerMm : 1;
    StiffnessTable found;
    for (const auto& row : table.rows) {
        const StiffnessReading reading{row.values[0], row.values[1] * perLoad,
                                       row.values[2] * perDeflection};
        const auto check = [&](std::size_t column, double value, const Range& range,
                               std::string_view unit) {
            if (!range.contains(value)) {
                addFault(table.faults, row.line, column, IssueCode::outOfRange, Amount{value, unit},
                         Bounds{.range = range, .unit = unit});
            }
        };
        check(1, reading.position_mm, limits::readingPlace_mm, "mm");
        check(2, reading.load_n, limits::readingLoad_n, "N");
        check(3, reading.deflection_um, limits::readingDeflection_um, "µm");
        found.readings.push_back(reading);
    }
    if (table.rows.empty() && table.faults.empty()) {
        addFault(table.faults, 0, 0, IssueCode::wrongCount, countOf(0), countOf(2));
    }
    found.faults = table.faults;
    if (!found.faults.empty()) {
        found.readings.clear();
    }
    return found;
}

} // namespace sparkout
