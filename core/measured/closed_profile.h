// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/number_table.h"
#include "core/tables/table_text.h"

#include <cstddef>
#include <vector>

namespace sparkout {

namespace limits {
inline constexpr std::size_t profilePoints = 36'000;
} // namespace limits

/// A section recorded by a roundness machine.
struct ClosedProfile {
    std::vector<double> radii_mm; ///< at even angles from 0
    std::size_t rows = 0;         ///< points of the table
    CellFaults faults;            ///< if there are any, there are no radii
};

/// Reads a table of two columns, angle [°] and radius, in either dialect, with or without a line of
/// headings. A second heading in µm marks deviations from the nominal radius; otherwise the values
/// are radii in mm. Angles rise within one turn; uneven ones are interpolated linearly.
[[nodiscard]] ClosedProfile readClosedProfile(const TableText& text, double nominalRadius_mm);

} // namespace sparkout
