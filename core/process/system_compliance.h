// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance.h"
#include "core/project/project.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// Lengths of the zones of traverse grinding [mm] [MODEL-5]:
/// РЗ1 = B − o1, РЗ2 = B − o2, НЗ = L_p − РЗ1 − РЗ2.
struct ZoneLengths {
    double rz1 = 0, nz = 0, rz2 = 0;
};
[[nodiscard]] ZoneLengths zoneLengths(const Project& project);

/// Width of cut while the wheel dwells at a reversal [mm]: the zone, at most B before the wall of a
/// blind bore [MODEL-5].
[[nodiscard]] double plungeWidth(const Project& project, double zoneLength_mm);

/// The part of a reversal zone that the wheel does not reach [mm]: the relief before the wall of a
/// blind bore, otherwise 0. It is excluded from the zone's middle, its sections and its length.
[[nodiscard]] double reliefBehind(const Project& project, double zoneLength_mm);

/// A place along the ground length and the compliance there.
struct CompliantPoint {
    double position_mm = 0; ///< from the headstock end of the ground length [mm]
    double gamma_mm_n = 0;  ///< γ [mm/N]
    double length_mm = 0;   ///< length ℓ represented: the zone, or the slice of L_p [mm]
};

/// The zones РЗ1, НЗ, РЗ2 (at the middles of their reachable parts) or the J sections (at the
/// middles of equal slices), with γ as given or computed from stiffness and shaft: traverse G(x,x),
/// plunge the mean of G(x,s) over the contact, internal the quill's [MODEL-6]. Here and below a
/// stopped result must not be used (see Compliance).
[[nodiscard]] std::vector<CompliantPoint> compliantPoints(const Project& project,
                                                          const std::stop_token& stop = {});

/// The sections of divided zones, zone by zone from the entry on, at the middles of equal slices of
/// the reachable part: γ as given for the zone, or G(x,x) [MODEL-5].
[[nodiscard]] std::vector<CompliantPoint> zoneSectionPoints(const Project& project,
                                                            const std::stop_token& stop = {});

/// Converts a position from the headstock to the distance from the entry end of the ground length
/// [mm], or back.
[[nodiscard]] double fromEntry(const Project& project, double position_mm);

/// γ(x) = G(x,x) at a place, and the terms that add up to it.
struct CompliantPlace {
    double position_mm = 0; ///< from the headstock end of the ground length [mm]
    ComplianceParts parts;  ///< [mm/N]
};

/// Evenly spaced places (at least 2) from end to end of the shaft, or of the bore, where the quill
/// gives the same value everywhere. Empty where γ is given; a stop leaves out the last ones.
[[nodiscard]] std::vector<CompliantPlace> complianceAlong(const Project& project, int places,
                                                          const std::stop_token& stop = {});

/// Index into compliantPoints() of the zone or section that carries the gauge, or whose middle is
/// nearest to its free position.
[[nodiscard]] int gaugeSection(const Project& project);

/// Index of the zone or section of a point of a run: the zones or sections come first, then the
/// sections of the zones, or the gauge's free position.
[[nodiscard]] std::size_t placeOfPoint(const Project& project, std::size_t point);

/// The gauge's free position in plunge with its γ: given, computed from the shaft, or interpolated
/// between the sections' middles (constant beyond the outermost); its length is 0. Requires
/// gauge.position_mm.
[[nodiscard]] CompliantPoint freeGaugePoint(const Project& project,
                                            const std::vector<CompliantPoint>& sections,
                                            const std::stop_token& stop = {});

/// G(x,s) [mm/N] for each x of `at` (rows) and s of `from` (columns), row by row; positions along
/// the ground length [mm]. Computed from stiffness and shaft: only when no γ is given. In a bore
/// every place moves as the quill does.
[[nodiscard]] std::vector<double> influenceRows(const Project& project,
                                                const std::vector<double>& at,
                                                const std::vector<double>& from,
                                                const std::stop_token& stop = {});

} // namespace sparkout
