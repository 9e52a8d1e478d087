// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/search/search_cases.h"

namespace sparkout::search_cases {

/// Small cases under gauge control, each radius by its own balance.
inline Project followable(Operation operation, unsigned seed) {
    for (unsigned salt = 0;; ++salt) {
        Project p = smallCase(seed + 1000 * salt);
        const bool isAlone =
            !p.machine->wheel_contact && !p.sections_coupled && !p.gauge->position_mm;
        if (p.operation == operation && p.gauge->control == Control::gauge && isAlone) {
            Dice dice(seed);
            p.zone_sections = 1; // several are not followed alone
            p.machine->dwell_entry_s =
                dice.integer(0, 2) / 3.0; // whole revolutions at 180 a minute
            p.machine->dwell_exit_s = dice.integer(0, 2) / 3.0;
            p.machine->overrun_entry_mm = dice.uniform(0.51, 0.8) * p.wheel->width_mm;
            p.machine->overrun_exit_mm = dice.uniform(0.51, 0.8) * p.wheel->width_mm;
            p.machine->plunge_feed_mm_min = dice.uniform(0.3, 3);
            p.machine->reversal_infeed = static_cast<ReversalInfeed>(seed % 3);
            p.cycle->stages.assign(2, {});
            for (Stage& stage : p.cycle->stages) {
                if (operation == Operation::traverse) {
                    stage.radial_feed_mm = dice.uniform(0.002, 0.012);
                    stage.axial_feed_mm_min = dice.uniform(500, 2000);
                } else {
                    stage.radial_feed_mm_min = dice.uniform(0.1, 1.5);
                }
                stage.stock_mm = p.part->stock_mm / 2;
            }
            return p;
        }
    }
}

inline Project traversed(unsigned seed) {
    return followable(Operation::traverse, seed);
}

/// Fed all the time instead of at the reversals, by about as much in a double stroke.
inline Project fedContinuously(unsigned seed) {
    Project p = traversed(seed);
    for (Stage& stage : p.cycle->stages) {
        const double travel_mm = p.part->length_mm - p.wheel->width_mm + p.machine->overrun_entry_mm
                                 + p.machine->overrun_exit_mm;
        stage.continuous_feed_mm_min =
            *stage.radial_feed_mm * *stage.axial_feed_mm_min / (2 * travel_mm);
        stage.radial_feed_mm = 0;
    }
    return p;
}

inline Project plunged(unsigned seed) {
    return followable(Operation::plunge, seed);
}

} // namespace sparkout::search_cases
