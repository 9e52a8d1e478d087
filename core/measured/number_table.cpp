// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/number_table.h"

#include "core/file/text_table.h"
#include "core/measured/column_match.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

namespace {

constexpr double wholeTurn_deg = 360;
constexpr std::size_t leastPoints = 8;

struct Point {
    double angle_deg = 0, radius_mm = 0;
};

/// The points of a table; invalid ones are its faults.
std::vector<Point> pointsOf(NumberTable<2>& table, double nominalRadius_mm) {
    const bool isDeviation =
        !table.headings.empty() && matchHeading(table.headings.back()).unit == ColumnUnit::um;
    const Range diameters = boundsOf(ColumnQuantity::diameter).range;
    const Bounds radii{.range = {.low = diameters.low / 2, .high = diameters.high / 2},
                       .unit = "mm"};
    std::vector<Point> points;
    for (const auto& row : table.rows) {
        const auto [angle, value] = row.values;
        const double least = points.empty() ? -wholeTurn_deg : points.back().angle_deg;
        const double most =
            points.empty() ? wholeTurn_deg : points.front().angle_deg + wholeTurn_deg;
        const bool rises = points.empty() ? angle >= least : angle > least;
        const double radius = isDeviation ? nominalRadius_mm + value / units::umPerMm : value;
        if (!rises || angle > most) {
            addFault(table.faults, row.line, 1, IssueCode::outOfRange, Amount{angle, "°"},
                     Bounds{.range = {.low = least, .high = most}, .unit = "°"});
        } else if (!radii.range.contains(radius)) {
            addFault(table.faults, row.line, 2, IssueCode::outOfRange, Amount{radius, "mm"}, radii);
        } else if (angle < most || points.empty()) { // otherwise the first point, at the turn's end
            points.push_back({angle, radius});
        }
    }
    return points;
}

/// The same number of radii at even angles, from the first point's angle.
std::vector<double> placedEvenly(const std::vector<Point>& points) {
    constexpr double even = 1e-3; // relative to a step, as rounded in the table
    const auto count = static_cast<double>(points.size());
    const double from = points.front().angle_deg;
    std::vector<double> radii;
    std::size_t next = 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double at = from + wholeTurn_deg * static_cast<double>(k) / count;
        if (std::abs(points[k].angle_deg - at) < even * wholeTurn_deg / count) {
            radii.push_back(points[k].radius_mm);
            continue;
        }
        while (next < points.size() && points[next].angle_deg < at) {
            ++next;
        }
        const Point& before = points[next - 1];
        const Point after = next < points.size()
                                ? points[next]
                                : Point{from + wholeTurn_deg, points.front().radius_mm};
        const double share = (at - before.angle_deg) / (after.angle_deg - before.angle_deg);
        radii.push_back(before.radius_mm + share * (after.radius_mm - before.radius_mm));
    }
    return radii;
}

} // namespace

ClosedProfile readClosedProfile(const TableText& text, double nominalRadius_mm) {
    NumberTable<2> table = readNumbers<2>(text);
    const std::vector<Point> points = pointsOf(table, nominalRadius_mm);
    ClosedProfile profile;
    if (table.faults.empty()
        && (points.size() < leastPoints || points.size() > limits::profilePoints)) {
        addFault(table.faults, 0, 0, IssueCode::wrongCount, countOf(points.size()),
                 countOf(leastPoints));
    }
    profile.rows = points.size();
    profile.faults = table.faults;
    if (profile.faults.empty()) {
        profile.radii_mm = placedEvenly(points);
    }
    return profile;
}

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
