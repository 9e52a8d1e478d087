// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// The part after a cycle that was controlled from one place along it.
struct GaugePosition {
    double position_mm = 0;         ///< of the gauge, from the headstock end of the ground length
    Zone zone = Zone::section;      ///< that it stands in (traverse)
    double compliance_mm_per_n = 0; ///< γ there
    RunStatus status = RunStatus::completed;
    double time_s = 0;
    /// Diameter deviations from nominal over all sections or zones, and where they are.
    double deviationMin_mm = 0, deviationMax_mm = 0;
    std::size_t sectionOfMin = 0, sectionOfMax = 0;
    /// Mean diameter less nominal of each section or zone, headstock first or РЗ1, НЗ, РЗ2.
    std::vector<double> meanDeviations_mm;
    double taper_mm = 0;  ///< of the mean radius: tailstock end less headstock end, straight fit
    double margin_mm = 0; ///< least distance of a diameter to the limits; negative outside
};

/// How the accuracy over the length depends on where the gauge stands [MODEL-7, AKINTSEVA2020
/// section 3]: a gauge on the stiffest place leaves all other diameters larger, on the most
/// compliant one smaller. Under position control the gauge has no say and all positions are alike.
struct GaugePlacement {
    std::vector<GaugePosition> positions; ///< in the order asked for, as far as they were run
    bool stopped = false;                 ///< by a stop request
    /// The one with the largest margin among the completed; of equal neighbours the middle one.
    std::optional<std::size_t> best;
};

/// Places worth asking about: in plunge `count` ≥ 2 from end to end of the ground length, in
/// traverse the middles of the zones, for the model knows no more than a γ a zone.
[[nodiscard]] std::vector<double> gaugeCandidates(const Project& project, int count);

/// Called after each position.
using PlacementProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs the cycle of a valid project once for each position [mm] of the gauge within 0…L_p. The
/// gauge's own place and compliance are not read: γ comes from the shaft, or from between the
/// sections. In traverse a position stands for the zone it lies in.
[[nodiscard]] GaugePlacement placeGauge(const Project& project,
                                        const std::vector<double>& positions_mm,
                                        const PlacementProgress& progress = {},
                                        const std::stop_token& stop = {});

} // namespace sparkout
