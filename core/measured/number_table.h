// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/file/text_encoding.h"
#include "core/issue.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

/// A fault of a table: the issue and its cell.
struct CellFault {
    std::size_t line = 0;   ///< counted from 1; 0: the whole text
    std::size_t column = 0; ///< counted from 1; 0: the whole line
    Issue issue;            ///< the issue, without a path
    friend bool operator==(const CellFault&, const CellFault&) = default;
};

using CellFaults = std::vector<CellFault>;

/// A table of numbers only, in either dialect, with or without headings.
template <std::size_t columns>
struct NumberTable {
    struct Row {
        std::size_t line = 0;
        std::array<double, columns> values{};
    };
    std::vector<std::string> headings; ///< none, or one a column
    std::vector<Row> rows;
    CellFaults faults; ///< cells that are not numbers, and rows with too few
};

/// Further columns and empty lines are ignored.
template <std::size_t columns>
[[nodiscard]] NumberTable<columns> readNumbers(const TableText& text);

extern template NumberTable<2> readNumbers<2>(const TableText& text);
extern template NumberTable<3> readNumbers<3>(const TableText& text);

/// Adds a fault unless the list is full.
void addFault(CellFaults& faults, std::size_t line, std::size_t column, IssueCode code,
              Detail value, Detail limit);

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
