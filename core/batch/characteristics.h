// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace sparkout {

/// A value measured on every part of a batch: of each zone or section the mean, least and greatest
/// diameter and the radial runout, and whatever else the drawing, the drives, burn and
/// self-sharpening limit; of the part the time. Burn and self-sharpening, whose limits differ from
/// part to part, are in per cent of these.
struct Characteristic {
    const char* name = ""; ///< "diameter", "time", or that of the requirement
    const char* unit = ""; ///< µm, kW, s, %
    Zone zone = Zone::section;
    int section = -1;                ///< index of the zone or section; −1: the whole part
    std::optional<double> low, high; ///< limits
    double resolution = 0;           ///< width of the finest bins: a power of two
    const Requirement* requirement = nullptr; ///< null: the mean diameter, or the time
    bool isEstimate = false;                  ///< Ra without a measured value behind it
    bool knowsMachine = true; ///< false: the machine's form error is unknown and not included
};

[[nodiscard]] std::vector<Characteristic> characteristicsOf(const Project& project);

/// Whether its capability is reported: for a size or a form of the finished part that the drawing
/// limits. Not for the drives' power, nor for Ra, since the batch varies the depth of the pass but
/// not the wheel's face.
[[nodiscard]] bool hasCapability(const Characteristic& characteristic);

/// Whether it belongs to the finished surface, whose values are omitted where strips stay uncut.
[[nodiscard]] bool isOfSurface(const Characteristic& characteristic);

/// Mean diameter of a zone or section less the nominal one [µm].
[[nodiscard]] double meanDeviation_um(const SectionResult& section, double nominal_mm);

/// The measurements of one part of a batch.
struct PartOutcome {
    bool completed = false; ///< the cycle reached size; otherwise nothing was measured
    bool good = false;      ///< completed, and every requirement is met
    double margin = 0;      ///< least relative margin of its requirements
    /// Failed kinds, anywhere on the part. Where strips stay uncut the overlap fails and no
    /// requirement on the finished surface.
    std::array<bool, constraintKinds> fails{};
    std::array<bool, constraintKinds> asked{}; ///< kinds that were evaluated
    /// Values of the characteristics; NaN: none, such as the roughness without a cut, and values of
    /// the finished surface where strips stay uncut.
    std::vector<double> values;
};

/// Measures a result into `outcome`, for the characteristics of its project.
void measure(const SimulationResult& result, const std::vector<Characteristic>& characteristics,
             PartOutcome& outcome);

/// One part of a batch that was run.
struct PartRecord {
    std::int64_t part = 0;
    std::vector<double> factors; ///< values, in the order of givenFactors()
    PartOutcome outcome;
};

/// Receives a part; returns false to end the batch.
using PartSink = std::function<bool(const PartRecord&)>;

} // namespace sparkout
