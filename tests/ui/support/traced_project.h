// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/measured/measured_cycles.h"

/// A plunge whose cycle was recorded at a machine that yields more and whose wheel is sharper.
namespace sparkout::traced {

inline constexpr double yields = 1.25, sharper = 0.7; ///< of the truth
inline constexpr double gamma = 5e-4;                 ///< of the project [mm/N]

inline Project plunge() {
    return measured_cycles::yieldingPlunge(2);
}

inline Project truth() {
    Project project = plunge();
    project.machine->compliance_mm_per_n = std::vector<double>{yields * gamma, yields * gamma};
    project.wheel->dullness *= sharper;
    return project;
}

/// With the size and, if wanted, the power of the true cycle, which begins `shift_s` after the
/// recording.
inline Project project(bool withPower = false, double shift_s = 0) {
    Project project = plunge();
    const measured_cycles::Record cycle = measured_cycles::record(truth(), 1);
    Measured& measured = project.measured.emplace();
    measured.traces.push_back(
        measured_cycles::trace(TraceQuantity::gauge_size, cycle,
                               {.noise = 0.0005, .offset = 0.02, .shift_s = shift_s, .seed = 7}));
    if (withPower) {
        measured.traces.push_back(
            measured_cycles::trace(TraceQuantity::wheel_power, cycle,
                                   {.noise = 0.01, .offset = 0.8, .shift_s = shift_s, .seed = 8}));
        measured.traces.back().idle = 0.8;
    }
    for (MeasuredTrace& trace : measured.traces) {
        trace.source = "cycle-17.csv";
    }
    return project;
}

/// Calibrated on first.csv, with the size of a later cycle, second.csv.
inline Project heldOut() {
    Project project = plunge();
    const double dullness = project.wheel->dullness;
    const measured_cycles::Record cycle = measured_cycles::record(project, 1);
    Measured& measured = project.measured.emplace();
    measured.calibrations.push_back({.input = "/wheel/dullness",
                                     .value = dullness,
                                     .low = 0.9 * dullness,
                                     .high = 1.1 * dullness,
                                     .data = "first.csv",
                                     .count = 200,
                                     .date = "2026-11-30"});
    measured.traces.push_back(measured_cycles::trace(
        TraceQuantity::gauge_size, cycle,
        {.from_s = -1, .to_s = cycle.end_s.back() + 2, .noise = 0.0005, .shift_s = 0.3}));
    measured.traces.back().source = "second.csv";
    return project;
}

} // namespace sparkout::traced
