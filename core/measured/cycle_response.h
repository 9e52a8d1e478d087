// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// Factors on the inputs that determine the depths of cut.
struct CycleFactors {
    double alpha = 1, beta = 1, compliance = 1, flowStress = 1, dullness = 1;
    std::vector<double> places; ///< factors of the compliance of each zone or section; empty: 1
    double blankRunout_mm = 0;  ///< ΔR itself
    friend bool operator==(const CycleFactors&, const CycleFactors&) = default;
};

/// The factors of an unchanged project.
[[nodiscard]] CycleFactors factorsOf(const Project& project);

/// Whether zones or sections can have their own compliances: given, or computed separately.
[[nodiscard]] bool hasPlaceCompliances(const Project& project);

/// Multiplies γ place by place; a computed γ becomes a given one.
void scalePlaceCompliances(Project& project, const std::vector<double>& factors);

/// Returns the project whose cycle has the factors α and β in every balance. With a wheel contact
/// the balance cannot be split between the two, and both must be 1. The forces are not multiplied:
/// they follow from the depths of cut. Where the force has a threshold, α is the factor of K and β
/// that of F'_0.
[[nodiscard]] Project scaledProject(const Project& project, const CycleFactors& factors);

/// The expected signals of gauge, drive and force sensor in a cycle, one value for each step: a
/// double stroke or a revolution. Powers and forces follow the project's own law at the depths cut.
struct CycleResponse {
    bool ran = false;
    std::vector<double> end_s;   ///< 0 and the end of each step
    std::vector<double> size_mm; ///< D at the gauge less its target, by the gauge's rule
    std::vector<std::vector<double>> placeSizes_mm; ///< sizes of each zone or section
    /// Middles of the steps; before the first and after the last nothing is cut, and contact is
    /// made or lost within half a step.
    std::vector<double> middle_s;
    std::vector<double> chip_kw;      ///< b·k_t·V_k·a, mean over the radii and places of a step
    std::vector<double> friction_kw;  ///< b·μ·k_r·V_k·√a
    std::vector<double> chip_n;       ///< b·k_s·a
    std::vector<double> friction_n;   ///< b·k_r·√a
    std::vector<double> deviation_um; ///< mean diameter of each place at the end less the nominal
};

/// Runs the cycle with given numbers of steps in its stages, whatever the gauge reads, so that the
/// signals change smoothly with the factors. Under position control the steps follow from the feed.
/// A stop ends it within a revolution; then it has not run.
[[nodiscard]] CycleResponse respond(const Project& project, const CycleFactors& factors,
                                    const std::vector<int>& stepsByStage, bool withPlaces,
                                    const std::stop_token& stop = {});

/// The number of steps of each stage under gauge control with these factors; empty if the cycle
/// does not end, and after a stop.
[[nodiscard]] std::vector<int> stepsByGauge(const Project& project, const CycleFactors& factors,
                                            const std::stop_token& stop = {});

/// Interpolates between values at rising times; constant outside.
[[nodiscard]] double valueAt(const std::vector<double>& times, const std::vector<double>& values,
                             double time);

/// The output of a first-order lag with this time constant, at rest at the first value, at the
/// times of a piecewise linear input, and interpolated exactly between them; a negative lag leads.
[[nodiscard]] std::vector<double> laggedKnots(const std::vector<double>& times,
                                              const std::vector<double>& values, double lag_s);
[[nodiscard]] double laggedBetween(const std::vector<double>& times,
                                   const std::vector<double>& values,
                                   const std::vector<double>& knots, double time, double lag_s);

/// The sizes of many parts with an unknown stock within the steps of the feed: for each zone or
/// section the mean diameter less the nominal one.
struct SizesOverPhases {
    std::vector<double> means_um;      ///< empty: no cycle reached size
    std::vector<double> deviations_um; ///< standard deviations of single parts
};

/// Computes the sizes over usualPhases(), one infeed of stock, for 256 evenly spaced stocks: a step
/// of the size over the stock is located to a 256th of the range.
[[nodiscard]] SizesOverPhases sizesOverPhases(const Project& project, const CycleFactors& factors,
                                              const std::stop_token& stop = {});

} // namespace sparkout
