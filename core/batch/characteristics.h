// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

/// What is measured of every part of a batch: of each zone or section the mean, least and greatest
/// diameter and the radial runout, and what else the drawing, the drives, burn and self-sharpening
/// limit; of the part the time. Burn and self-sharpening, whose limits differ from part to part,
/// are measured in per cent of them.
struct Characteristic {
    const char* name = ""; ///< "diameter", "time", or that of the requirement
    const char* unit = ""; ///< µm, kW, s, %
    Zone zone = Zone::section;
    int section = -1;                ///< index of the zone or section; −1: of the whole part
    std::optional<double> low, high; ///< limits
    double resolution = 0;           ///< width of the finest bins: a power of two
    const Requirement* requirement = nullptr; ///< null: the mean diameter, or the time
    bool isEstimate = false;                  ///< Ra that no measured one stands behind
    bool knowsMachine = true; ///< else the machine's own form is not known, and not in the values
};

[[nodiscard]] std::vector<Characteristic> characteristicsOf(const Project& project);

/// Whether its capability is reported: a size or a form of the finished part that the drawing
/// limits. Not of the drives' power, which is no part's, nor of Ra, of which the batch scatters the
/// pass's depth alone and not the wheel's face.
[[nodiscard]] bool hasCapability(const Characteristic& characteristic);

/// Whether it is of the finished surface, of which nothing is stated where strips stay uncut.
[[nodiscard]] bool isOfSurface(const Characteristic& characteristic);

/// Mean diameter of a zone or section less the nominal one [µm].
[[nodiscard]] double meanDeviation_um(const SectionResult& section, double nominal_mm);

/// One part of a batch, measured.
struct PartOutcome {
    bool completed = false; ///< the cycle reached size; else nothing was measured
    bool good = false;      ///< and every requirement holds
    double margin = 0;      ///< least relative margin of its requirements
    /// By kind: somewhere on the part. Where strips stay uncut it fails by the overlap, and by
    /// nothing that is of the finished surface.
    std::array<bool, constraintKinds> fails{};
    std::array<bool, constraintKinds> asked{}; ///< by kind: held against anything at all
    /// Of the characteristics; NaN: none, as the roughness of no cut, and where strips stay uncut
    /// all that is of the finished surface.
    std::vector<double> values;
};

/// Measures a result into `outcome`, for the characteristics of its project.
void measure(const SimulationResult& result, const std::vector<Characteristic>& characteristics,
             PartOutcome& outcome);

} // namespace sparkout
