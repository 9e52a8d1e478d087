// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include "tests/core/support/project_fixtures.h"

#include <QString>

#include <cstddef>
#include <vector>

/// Double strokes whose every pass is computed by hand.
namespace sparkout::strokes_by_hand {

inline constexpr double um = 1e-3; // [mm]

/// One turn a second, strokes of ten; the plunge-in feeds 4 µm a turn, dwells last one turn. The
/// wheel is sharp, so that a = h/A: A = 2 in strokes (b = 10 mm), 3 in the reversal zones' plunge
/// passes (b = 20 mm); or A = 1 in all where the system is rigid.
inline Project byHand(bool rigid) {
    Project p = fixtures::traverse();
    p.part->diameter_mm = 30;
    p.part->length_mm = 100;
    p.part->initial_runout_mm = 0;
    p.part->radii_per_section = 4;
    p.wheel->width_mm = 40;
    p.wheel->dullness = 0;
    p.machine->work_speed_rpm = 60;
    p.machine->plunge_feed_mm_min = 0.24;
    p.machine->overrun_entry_mm = p.machine->overrun_exit_mm = 20;
    p.machine->dwell_entry_s = p.machine->dwell_exit_s = 1;
    const double gamma = rigid ? 1e-15 : 1 / (10 * fixtures::Law(p).ks);
    p.machine->compliance_mm_per_n = ZoneCompliance{gamma, gamma, gamma};
    p.gauge->control = Control::position;
    return p;
}

/// One stage that is fed so much in all.
inline void feed(Project& p, double reversal_um, double continuous_mm_min, double all_um) {
    p.part->stock_mm = all_um * um;
    p.cycle->stages = {fixtures::strokeStage(reversal_um * um, 600, all_um * um)};
    if (continuous_mm_min > 0) {
        p.cycle->stages[0].continuous_feed_mm_min = continuous_mm_min;
    }
}

/// A pass of the last radius, which is visited at the end of a turn [µm].
struct Cut {
    Zone zone;
    Step step;
    double programmed;
    double rigid;     ///< a with A = 1
    double compliant; ///< a with A = 2 and 3
};

/// Two double strokes, S_t = 8 µm at the entry. A = 3 in both reversal zones' plunge passes (b = 20
/// mm).
inline const std::vector<Cut> entryInfeed{
    {Zone::rz1, Step::e1, 4, 4, 4.0 / 3},        {Zone::rz1, Step::e1, 8, 4, 20.0 / 9},
    {Zone::rz1, Step::e2, 8, 0, 40.0 / 27},      {Zone::rz1, Step::e3, 8, 0, 40.0 / 27},
    {Zone::nz, Step::e1, 8, 8, 4.0 / 1},         {Zone::rz2, Step::e1, 8, 8, 4.0 / 1},
    {Zone::rz2, Step::e2, 8, 0, 4.0 / 3},        {Zone::rz1, Step::e4, 8, 0, 20.0 / 27},
    {Zone::nz, Step::e2, 8, 0, 2.0 / 1},         {Zone::rz2, Step::e3, 8, 0, 4.0 / 3},
    {Zone::rz1, Step::e5, 8, 0, 20.0 / 81},      {Zone::rz1, Step::e1, 12, 4, 364.0 / 243},
    {Zone::rz1, Step::e1, 16, 4, 1700.0 / 729},  {Zone::rz1, Step::e2, 16, 0, 3400.0 / 2187},
    {Zone::rz1, Step::e3, 16, 0, 3400.0 / 2187}, {Zone::nz, Step::e1, 16, 8, 5.0 / 1},
    {Zone::rz2, Step::e1, 16, 8, 14.0 / 3},      {Zone::rz2, Step::e2, 16, 0, 14.0 / 9},
    {Zone::rz1, Step::e4, 16, 0, 1700.0 / 2187}, {Zone::nz, Step::e2, 16, 0, 5.0 / 2},
    {Zone::rz2, Step::e3, 16, 0, 14.0 / 9},      {Zone::rz1, Step::e5, 16, 0, 1700.0 / 6561}};

/// What differs from a table of passes; empty when nothing does.
inline QString difference(const fixtures::Traced& run, const std::vector<Cut>& table, bool rigid) {
    if (run.trajectory.passes.size() != table.size()) {
        return QStringLiteral("%1 passes").arg(run.trajectory.passes.size());
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Pass& pass = run.trajectory.passes[i];
        const Visit& visit = run.visit(pass, run.trajectory.radii - 1);
        const double a = (rigid ? table[i].rigid : table[i].compliant) * um;
        if (pass.place.zone != table[i].zone || pass.place.step != table[i].step
            || !fixtures::within(visit.programmed_mm, table[i].programmed * um, 1e-15)
            || !fixtures::within(visit.actual_mm, a, 1e-12)) {
            return QStringLiteral("pass %1: %2 mm").arg(i).arg(visit.actual_mm, 0, 'g', 17);
        }
    }
    return {};
}

} // namespace sparkout::strokes_by_hand
