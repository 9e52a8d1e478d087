// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/measured/number_table.h"
#include "core/tables/table_text.h"

#include <vector>

namespace sparkout {

namespace limits {
inline constexpr Range readingPlace_mm{0, 1e5};
inline constexpr Range readingLoad_n{1e-3, 1e6};
inline constexpr Range readingDeflection_um{-1e5, 1e5};
} // namespace limits

/// One reading of a stiffness trial.
struct StiffnessReading {
    double position_mm = 0;   ///< from the headstock end of the shaft [mm]
    double load_n = 0;        ///< radial, > 0 [N]
    double deflection_um = 0; ///< from the unloaded state to this load [µm]
};

struct StiffnessTable {
    std::vector<StiffnessReading> readings;
    CellFaults faults; ///< if there are any, there are no readings
};

/// Reads a table of three columns, place [mm], load [N] and deflection [µm], in either dialect,
/// with or without headings; a heading in mm or kN is heeded.
[[nodiscard]] StiffnessTable readStiffnessTable(const TableText& text);

} // namespace sparkout
