// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sparkout {

namespace limits {
inline constexpr std::size_t factors = 16; ///< of a batch, those of its zones among them
} // namespace limits

/// The factors a batch may scatter by, in the order of their table.
enum class FactorKind {
    stock,
    runout,
    dullness,
    wheelDiameter,
    flowStress,
    compliance,
    contactWidth,
    machineForm,
    runoutAt,
    gaugeError,
    gaugeAge,
    partWarmer
};

/// Whether it is an error of what the gauge reads. Corners leave those at their middle: they are
/// random and independent, and no cycle makes up for them.
[[nodiscard]] constexpr bool isOfReading(FactorKind kind) {
    return kind >= FactorKind::gaugeError;
}

/// A factor of a batch that is given, with what its input allows.
struct GivenFactor {
    FactorKind kind;
    Factor law;            ///< measured values in rising order
    Range allowed;         ///< hard limits of the input it stands for
    int place = -1;        ///< zone or section whose own value it is; below 0: of the whole part
    bool isOfZone = false; ///< that place is a zone

    /// Follows the number of the part and takes no random number.
    [[nodiscard]] bool isLaw() const { return law.grows.has_value(); }
};

/// The given factors in the order of the table: the order of the correlation matrix.
[[nodiscard]] std::vector<GivenFactor> givenFactors(const Project& project);

/// Those of single zones or sections, zone by zone. A constant is no factor; those are apart.
[[nodiscard]] std::vector<GivenFactor> zoneFactors(const Project& project);
[[nodiscard]] std::vector<GivenFactor> zoneConstants(const Project& project);

/// All that scatter: those of the part, then those of its zones or sections.
[[nodiscard]] std::vector<GivenFactor> scatteredFactors(const Project& project);

/// Of the factors those that have corners, and how many corners there are; 1 without any.
[[nodiscard]] std::size_t corneredCount(const std::vector<GivenFactor>& factors);
[[nodiscard]] inline std::int64_t cornerCount(const std::vector<GivenFactor>& factors) {
    return std::int64_t{1} << corneredCount(factors);
}

/// The usual causes of scatter that the batch of a project leaves out, in the order of their table:
/// not given, or without the machine's number they multiply, or left at their middle by corners. Of
/// a project without a batch all of them; errors of the reading where the gauge ends a stage.
[[nodiscard]] std::vector<FactorKind> notCounted(const Project& project);

/// Key of a factor in the file, "stock_mm".
[[nodiscard]] const char* factorKey(FactorKind kind);
/// The same of a zone or section, "zone_stock_mm rz1", "zone_compliance section 2" (from 0).
[[nodiscard]] std::string factorKey(const GivenFactor& factor);
/// Label of its input.
[[nodiscard]] const char* factorLabel(const GivenFactor& factor);
[[nodiscard]] const char* factorLabel(FactorKind kind);

} // namespace sparkout
