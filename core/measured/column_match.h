// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/tables/column_unit.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

/// What a column of a table of measurements may hold.
enum class ColumnQuantity {
    ignored,
    part,               ///< number or name of the part
    place,              ///< zone or section
    diameter,           ///< of a part; several columns: several diameters of it
    diameter_deviation, ///< the same less the nominal diameter
    roundness,
    radial_runout,
    cylindricity,
    roughness_ra,
    when, ///< of a part, in words
    note,
    time, ///< of the samples of traces
    gauge_size,
    wheel_power,
    spindle_current,
    normal_force,
    count_
};

/// How a column is read; proposed by its heading, for the user to change.
struct ColumnMatch {
    std::string heading;
    ColumnQuantity quantity = ColumnQuantity::ignored;
    ColumnUnit unit = ColumnUnit::none;
    std::optional<int> place; ///< zone or section of all its values, where the heading names one
    friend bool operator==(const ColumnMatch&, const ColumnMatch&) = default;
};

/// What a heading such as "Diameter, mm", "Диаметр [мм]" or "P (kW)" means.
[[nodiscard]] ColumnMatch matchHeading(std::string_view heading);

/// The columns of a table by the headings in its first row.
[[nodiscard]] std::vector<ColumnMatch> matchHeadings(std::string_view text, char delimiter);

/// A match as a table needs it: beside a time "diameter" is the size at the gauge.
void settleMatches(std::vector<ColumnMatch>& matches);

/// What a value in the unit is to be multiplied by, to be in that of the project's section
/// `measured`; without a unit 1. Nothing where the quantity has no such unit.
[[nodiscard]] std::optional<double> factorOf(ColumnQuantity quantity, ColumnUnit unit);

/// Whether its values are numbers.
[[nodiscard]] bool isNumeric(ColumnQuantity quantity);
/// Whether it is recorded over time.
[[nodiscard]] bool isTrace(ColumnQuantity quantity);

/// What the values of a quantity may be, in the unit of the section.
[[nodiscard]] Bounds boundsOf(ColumnQuantity quantity);

/// The units that a quantity may be given in, for a message.
[[nodiscard]] Keys unitsFor(ColumnQuantity quantity);

/// A zone by its name, or a place by its number; nothing where it is neither.
[[nodiscard]] std::optional<int> zoneNamed(std::string_view text);

} // namespace sparkout
