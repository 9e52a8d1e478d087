// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_project.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// What a cycle would show to gauge, drive and force sensor, step by step: a double stroke or a
/// revolution is one value. Powers and forces are of the project's own law at the depths cut.
struct CycleResponse {
    bool ran = false;
    std::vector<double> end_s;   ///< 0 and the end of each step
    std::vector<double> size_mm; ///< D at the gauge less its target, by the gauge's rule
    std::vector<std::vector<double>> placeSizes_mm; ///< the same of each zone or section
    /// Of each step; before the first and behind the last one nothing is cut, and half a step goes
    /// by until the wheel is in full contact or out of it.
    std::vector<double> middle_s;
    std::vector<double> chip_kw;      ///< b·k_t·V_k·a, mean of the step over radii and places
    std::vector<double> friction_kw;  ///< b·μ·k_r·V_k·√a
    std::vector<double> chip_n;       ///< b·k_s·a
    std::vector<double> friction_n;   ///< b·k_r·√a
    std::vector<double> deviation_um; ///< mean diameter of each place at the end less the nominal
};

/// Runs the cycle with so many steps in each of its stages, whatever the gauge would say: so what
/// it shows changes evenly with the factors. Under position control the steps follow from the feed.
/// A stop ends it within a revolution; then it has not run.
[[nodiscard]] CycleResponse respond(const Project& project, const CycleFactors& factors,
                                    const std::vector<int>& stepsByStage, bool withPlaces,
                                    const std::stop_token& stop = {});

/// The steps of each stage that the gauge asks for with these factors; empty where the cycle does
/// not end, and after a stop.
[[nodiscard]] std::vector<int> stepsByGauge(const Project& project, const CycleFactors& factors,
                                            const std::stop_token& stop = {});

/// A value between those given at rising times, the outermost beyond them.
[[nodiscard]] double valueAt(const std::vector<double>& times, const std::vector<double>& values,
                             double time);

/// The same through a gauge that follows by an exponential of this time constant, from rest at the
/// first value; below 0 it leads.
[[nodiscard]] double laggedAt(const std::vector<double>& times, const std::vector<double>& values,
                              double time, double lag_s);

} // namespace sparkout
