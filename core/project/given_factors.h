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
inline constexpr std::size_t factors = 16; ///< of a batch, including those of its zones
} // namespace limits

/// The factors by which a batch may scatter, in the order of their table.
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
    wheelPhase,
    gaugeError,
    gaugeAge,
    partWarmer
};

/// Whether the factor is an error of the gauge's reading. Corners keep these at factorMiddle():
/// they are random and independent, and no cycle compensates them.
[[nodiscard]] constexpr bool isOfReading(FactorKind kind) {
    return kind >= FactorKind::gaugeError;
}

/// A given factor of a batch and the range of its input.
struct GivenFactor {
    FactorKind kind;
    Factor law;            ///< measured values in rising order
    Range allowed;         ///< hard limits of the input
    int place = -1;        ///< zone or section that the factor belongs to; negative: the whole part
    bool isOfZone = false; ///< the place is a zone

    /// Whether the factor follows the number of the part and takes no random number.
    [[nodiscard]] bool isLaw() const { return law.grows.has_value(); }
};

/// The given factors in the order of the table: the order of the correlation matrix.
[[nodiscard]] std::vector<GivenFactor> givenFactors(const Project& project);

/// The factors of single zones or sections, zone by zone, without constants.
[[nodiscard]] std::vector<GivenFactor> zoneFactors(const Project& project);
[[nodiscard]] std::vector<GivenFactor> zoneConstants(const Project& project);

/// All factors that scatter: those of the part, then those of its zones or sections.
[[nodiscard]] std::vector<GivenFactor> scatteredFactors(const Project& project);

/// The number of factors that have corners, and the number of corners; 1 without such factors.
[[nodiscard]] std::size_t corneredCount(const std::vector<GivenFactor>& factors);
[[nodiscard]] inline std::int64_t cornerCount(const std::vector<GivenFactor>& factors) {
    return std::int64_t{1} << corneredCount(factors);
}

/// The usual causes of scatter that the project's batch leaves out, in the order of their table:
/// not given, or without the machine value that they multiply, or kept at their middle by corners.
/// Without a batch these are all causes; errors of the reading count only where the gauge ends a
/// stage.
[[nodiscard]] std::vector<FactorKind> notCounted(const Project& project);

/// Key of a factor in the file, "stock_mm".
[[nodiscard]] const char* factorKey(FactorKind kind);
/// The key of a factor of a zone or section, "zone_stock_mm rz1", "zone_compliance section 2" (from
/// 0).
[[nodiscard]] std::string factorKey(const GivenFactor& factor);
/// Label of its input.
[[nodiscard]] const char* factorLabel(const GivenFactor& factor);
[[nodiscard]] const char* factorLabel(FactorKind kind);

} // namespace sparkout
