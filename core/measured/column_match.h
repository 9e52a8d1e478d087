// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_table.h"
#include "core/issue.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

/// The possible quantities of a column of measurements.
enum class ColumnQuantity {
    ignored,
    part,               ///< number or name of the part
    place,              ///< zone or section
    diameter,           ///< diameter of a part; several columns: several diameters
    diameter_deviation, ///< less the nominal diameter
    roundness,
    radial_runout,
    cylindricity,
    roughness_ra,
    when, ///< time of a part, as text
    note,
    time, ///< time of the samples of traces
    gauge_size,
    wheel_power,
    spindle_current,
    normal_force,
    count_
};

/// The interpretation of a column, proposed by its heading and changeable by the user.
struct ColumnMatch {
    std::string heading;
    ColumnQuantity quantity = ColumnQuantity::ignored;
    ColumnUnit unit = ColumnUnit::none;
    std::optional<int> place; ///< zone or section of all its values, if the heading names one
    friend bool operator==(const ColumnMatch&, const ColumnMatch&) = default;
};

/// The meaning of a heading such as "Diameter, mm", "Диаметр [мм]" or "P (kW)".
[[nodiscard]] ColumnMatch matchHeading(std::string_view heading);

/// The columns of a table by the headings in its first row.
[[nodiscard]] std::vector<ColumnMatch> matchHeadings(std::string_view text, char delimiter);

/// Adapts the matches to the table: with a time column, "diameter" is the size at the gauge.
void settleMatches(std::vector<ColumnMatch>& matches);

/// The factor that converts a value in the unit to the unit of the project's section `measured`; 1
/// without a unit. Empty if the quantity does not have this unit.
[[nodiscard]] std::optional<double> factorOf(ColumnQuantity quantity, ColumnUnit unit);

/// Whether its values are numbers.
[[nodiscard]] bool isNumeric(ColumnQuantity quantity);
/// Whether it is recorded over time.
[[nodiscard]] bool isTrace(ColumnQuantity quantity);

/// The allowed range of a quantity, in the unit of the section.
[[nodiscard]] Bounds boundsOf(ColumnQuantity quantity);

/// The allowed units of a quantity, for a message.
[[nodiscard]] Keys unitsFor(ColumnQuantity quantity);

/// A zone by its name, or a place by its number; empty if it is neither.
[[nodiscard]] std::optional<int> zoneNamed(std::string_view text);

} // namespace sparkout
