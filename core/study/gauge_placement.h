// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Results of one cycle with independent and with coupled sections [MODEL-6].
struct CouplingComparison {
    SimulationResult independent;
    SimulationResult coupled;
    /// Mean diameter of each section, coupled less independent [mm].
    std::vector<double> differences_mm;

    [[nodiscard]] bool stopped() const {
        return independent.status == RunStatus::stopped || coupled.status == RunStatus::stopped;
    }
};

/// Whether the two can be compared, and the reason why not.
enum class CouplingAnswer {
    comparable,
    traverse,        ///< the wheel is on one zone at a time, so that nothing is coupled
    givenCompliance, ///< γ of each section does not contain the influence of one section on another
};
[[nodiscard]] CouplingAnswer couplingOf(const Project& project);

/// Runs a valid, comparable project with independent and with coupled sections, whatever its own
/// setting.
[[nodiscard]] CouplingComparison compareCoupling(const Project& project,
                                                 const std::stop_token& stop = {});

/// Returns the mean diameter of a section less the nominal one [mm].
[[nodiscard]] double meanDiameterDeviation(const SectionResult& section, const Part& part);

/// The part after a cycle with the gauge at one position.
struct GaugePosition {
    double position_mm = 0;         ///< position from the headstock end of the ground length
    Zone zone = Zone::section;      ///< the gauge's zone (traverse)
    double compliance_mm_per_n = 0; ///< γ at the gauge
    RunStatus status = RunStatus::completed;
    double time_s = 0;
    /// Least and greatest deviation of the diameters from nominal over all sections or zones, and
    /// their places.
    double deviationMin_mm = 0, deviationMax_mm = 0;
    std::size_t sectionOfMin = 0, sectionOfMax = 0;
    /// Mean diameter less nominal of each section or zone, headstock first or РЗ1, НЗ, РЗ2.
    std::vector<double> meanDeviations_mm;
    double taper_mm = 0;  ///< of the mean radius: tailstock end less headstock end, linear fit
    double margin_mm = 0; ///< least distance of a diameter to the limits; negative outside
};

/// Accuracy over the length depending on the position of the gauge [MODEL-7, AKINTSEVA2020 section
/// 3]: a gauge on the stiffest place leaves all other diameters larger, on the most compliant one
/// smaller. Under position control the gauge has no effect.
struct GaugePlacement {
    std::vector<GaugePosition> positions; ///< in the order requested, as far as they were run
    bool stopped = false;                 ///< by a stop request
    /// The completed position with the largest margin; among equal neighbours the middle one.
    std::optional<std::size_t> best;
};

/// Returns useful positions: in plunge grinding `count` ≥ 2 from end to end of the ground length,
/// in traverse grinding the middles of the zones, because the model has one γ per zone.
[[nodiscard]] std::vector<double> gaugeCandidates(const Project& project, int count);

/// Receives the progress after each position.
using PlacementProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs the cycle of a valid project once for each position [mm] of the gauge within 0…L_p. The
/// gauge's own place and compliance are not used: γ is computed from the shaft, or interpolated
/// between the sections. In traverse a position represents its zone.
[[nodiscard]] GaugePlacement placeGauge(const Project& project,
                                        const std::vector<double>& positions_mm,
                                        const PlacementProgress& progress = {},
                                        const std::stop_token& stop = {});

} // namespace sparkout
