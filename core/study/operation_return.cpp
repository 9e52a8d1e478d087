// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/operation_return.h"

#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/operation.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Restores a member's value from `last` unless it was edited after the switch.
template <class T>
void giveBack(T& made, const T& now, const T& thence, const T& last) {
    if (now == thence) {
        made = last;
    }
}

bool sameFeeds(const Stage& a, const Stage& b) {
    return a.radial_feed_mm == b.radial_feed_mm && a.radial_feed_mm_min == b.radial_feed_mm_min
           && a.feeds() == b.feeds();
}

/// The stage of the last project that corresponds to stage i: the same number or, if stages were
/// added or removed, the one with the feeds that the switch made; null if there is none.
const Stage* stageOfLastTime(std::size_t i, const Project& now, const Project& thence,
                             const Project& last) {
    const auto& stages = last.cycle->stages;
    if (stages.size() == now.cycle->stages.size()) {
        return &stages[i];
    }
    for (std::size_t j = 0; j < stages.size(); ++j) {
        if (sameFeeds(thence.cycle->stages[j], now.cycle->stages[i])) {
            return &stages[j];
        }
    }
    return nullptr;
}

/// Feeds belong to one operation: they are restored whatever was edited under the other.
void giveBackFeeds(Project& made, const Project& now, const Project& thence, const Project& last) {
    for (std::size_t i = 0; i < made.cycle->stages.size(); ++i) {
        Stage& stage = made.cycle->stages[i];
        const Stage* was = stageOfLastTime(i, now, thence, last);
        if (!was) {
            continue;
        }
        stage.axial_feed_mm_min = was->axial_feed_mm_min;
        if (stage.feeds() == was->feeds()) {
            stage.radial_feed_mm = was->radial_feed_mm;
            stage.radial_feed_mm_min = was->radial_feed_mm_min;
            stage.continuous_feed_mm_min = was->continuous_feed_mm_min;
        }
    }
}

void giveBackGauge(Gauge& made, const Gauge& now, const Gauge& thence, const Gauge& last) {
    giveBack(made.section, now.section, thence.section, last.section);
    giveBack(made.position_mm, now.position_mm, thence.position_mm, last.position_mm);
    giveBack(made.compliance_mm_per_n, now.compliance_mm_per_n, thence.compliance_mm_per_n,
             last.compliance_mm_per_n);
}

/// Removes what the switch added to the search.
void giveBackLevels(Project& made, const Project& now, const Project& thence, const Project& last) {
    if (!made.optimisation || !now.optimisation || !thence.optimisation || !last.optimisation) {
        return;
    }
    for (const auto levels : {&Optimisation::radial_feed_mm, &Optimisation::axial_feed_mm_min,
                              &Optimisation::radial_feed_mm_min}) {
        giveBack((*made.optimisation).*levels, (*now.optimisation).*levels,
                 (*thence.optimisation).*levels, (*last.optimisation).*levels);
    }
}

/// Restores values of single zones or sections that the switch to another operation dropped.
void giveBackZones(Project& made, const Project& last) {
    made.part->zone_stock_mm = last.part->zone_stock_mm;
    made.part->zone_runout_mm = last.part->zone_runout_mm;
    made.machine->zone_compliance = last.machine->zone_compliance;
    if (made.machine->form && last.machine->form) {
        made.machine->form->roundness_um = last.machine->form->roundness_um;
        made.machine->form->runout_um = last.machine->form->runout_um;
    }
    if (made.batch && last.batch) {
        made.batch->zone_stock_mm = last.batch->zone_stock_mm;
        made.batch->zone_runout_mm = last.batch->zone_runout_mm;
        made.batch->zone_compliance = last.batch->zone_compliance;
    }
}

} // namespace

Project withOperation(const Project& project, Operation operation, const Project* last) {
    Project made = withOperation(project, operation);
    if (!last || last->operation != operation || project.operation == operation) {
        return made;
    }
    const Project thence = withOperation(*last, project.operation);
    giveBackFeeds(made, project, thence, *last);
    giveBackGauge(*made.gauge, *project.gauge, *thence.gauge, *last->gauge);
    giveBack(made.part->length_mm, project.part->length_mm, thence.part->length_mm,
             last->part->length_mm);
    giveBack(made.least_steps, project.least_steps, thence.least_steps, last->least_steps);
    giveBackLevels(made, project, thence, *last);
    Machine& machine = *made.machine;
    const Machine& now = *project.machine;
    giveBack(machine.overrun_entry_mm, now.overrun_entry_mm, thence.machine->overrun_entry_mm,
             last->machine->overrun_entry_mm);
    giveBack(machine.overrun_exit_mm, now.overrun_exit_mm, thence.machine->overrun_exit_mm,
             last->machine->overrun_exit_mm);
    if (made.sections == last->sections) {
        giveBack(machine.compliance_mm_per_n, now.compliance_mm_per_n,
                 thence.machine->compliance_mm_per_n, last->machine->compliance_mm_per_n);
        giveBackZones(made, *last);
    }
    return fitted(std::move(made), operation);
}

} // namespace sparkout
