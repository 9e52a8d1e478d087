// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/operation.h"

#include "ui/session/defaults.h"
#include "ui/session/member.h"
#include "ui/session/texts.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

/// Gives a member back its value of `last` where it still is what the way from there made of it.
template <class T>
void giveBack(T& made, const T& now, const T& thence, const T& last) {
    if (now == thence) {
        made = last;
    }
}

bool sameFeeds(const Stage& a, const Stage& b) {
    return a.radial_feed_mm == b.radial_feed_mm && a.radial_feed_mm_min == b.radial_feed_mm_min
           && feeds(a) == feeds(b);
}

/// Which stage of the last time is stage i of now: the same number, or, where stages were added or
/// removed, the one with the feeds that the way from there made; null when it is another stage.
const Stage* stageOfLastTime(std::size_t i, const Project& now, const Project& thence,
                             const Project& last) {
    const auto& stages = last.cycle.stages;
    if (stages.size() == now.cycle.stages.size()) {
        return &stages[i];
    }
    for (std::size_t j = 0; j < stages.size(); ++j) {
        if (sameFeeds(thence.cycle.stages[j], now.cycle.stages[i])) {
            return &stages[j];
        }
    }
    return nullptr;
}

/// Feeds belong to one operation: they come back whatever was done under the other.
void giveBackFeeds(Project& made, const Project& now, const Project& thence, const Project& last) {
    for (std::size_t i = 0; i < made.cycle.stages.size(); ++i) {
        Stage& stage = made.cycle.stages[i];
        const Stage* was = stageOfLastTime(i, now, thence, last);
        if (!was) {
            continue;
        }
        stage.axial_feed_mm_min = was->axial_feed_mm_min;
        if (feeds(stage) == feeds(*was)) {
            stage.radial_feed_mm = was->radial_feed_mm;
            stage.radial_feed_mm_min = was->radial_feed_mm_min;
        }
    }
}

void giveBackGauge(Gauge& made, const Gauge& now, const Gauge& thence, const Gauge& last) {
    giveBack(made.section, now.section, thence.section, last.section);
    giveBack(made.position_mm, now.position_mm, thence.position_mm, last.position_mm);
    giveBack(made.compliance_mm_per_n, now.compliance_mm_per_n, thence.compliance_mm_per_n,
             last.compliance_mm_per_n);
}

/// What the way from there added to the search goes with it.
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

/// Of a compliance what its values are given for.
QString switchedText(const ConstMember& member) {
    if (member.field->kind != Kind::compliance) {
        return valueText(*member.field, member.owner);
    }
    const auto& given = member.field->as<GivenCompliance>(member.owner);
    if (std::holds_alternative<std::monostate>(given)) {
        return inputText(member.field->nullMeaning);
    }
    return std::holds_alternative<ZoneCompliance>(given)
               ? QCoreApplication::translate("OperationNotice", "zone by zone")
               : QCoreApplication::translate("OperationNotice", "section by section");
}

} // namespace

Project withOperation(const Project& project, Operation operation, const Project* last) {
    Project made = withOperation(project, operation);
    if (!last || last->operation != operation || project.operation == operation) {
        return made;
    }
    const Project thence = withOperation(*last, project.operation);
    giveBackFeeds(made, project, thence, *last);
    giveBackGauge(made.gauge, project.gauge, thence.gauge, last->gauge);
    giveBack(made.part.surface, project.part.surface, thence.part.surface, last->part.surface);
    giveBack(made.part.length_mm, project.part.length_mm, thence.part.length_mm,
             last->part.length_mm);
    giveBack(made.wheel.width_mm, project.wheel.width_mm, thence.wheel.width_mm,
             last->wheel.width_mm);
    giveBackLevels(made, project, thence, *last);
    Machine& machine = made.machine;
    const Machine& now = project.machine;
    giveBack(machine.overrun_entry_mm, now.overrun_entry_mm, thence.machine.overrun_entry_mm,
             last->machine.overrun_entry_mm);
    giveBack(machine.overrun_exit_mm, now.overrun_exit_mm, thence.machine.overrun_exit_mm,
             last->machine.overrun_exit_mm);
    if (made.sections == last->sections) {
        giveBack(machine.compliance_mm_per_n, now.compliance_mm_per_n,
                 thence.machine.compliance_mm_per_n, last->machine.compliance_mm_per_n);
    }
    return fitted(std::move(made), operation);
}

QStringList changesOfOperation(const Project& before, const Project& after) {
    QStringList changes;
    for (const char* path :
         {"/part/surface", "/part/length_mm", "/wheel/width_mm", "/machine/overrun_entry_mm",
          "/machine/overrun_exit_mm", "/machine/compliance_mm_per_n", "/gauge/section",
          "/gauge/position_mm", "/gauge/compliance_mm_per_n"}) {
        const ConstMember was = findMember(before, path);
        const QString old = switchedText(was);
        const QString made = switchedText(findMember(after, path));
        if (old != made) {
            changes += QStringLiteral("%1: %2 → %3").arg(inputText(was.field->label), old, made);
        }
    }
    return changes;
}

} // namespace sparkout
