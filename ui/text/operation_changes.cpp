// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/operation_changes.h"

#include "core/project/cycle.h"
#include "core/project/member.h"
#include "ui/text/defaults.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <vector>

namespace sparkout {

namespace {

QString byPlace(bool zones) {
    return zones ? QCoreApplication::translate("OperationNotice", "zone by zone")
                 : QCoreApplication::translate("OperationNotice", "section by section");
}

/// For a compliance, and for values of single zones or sections, states what they are given for.
QString switchedText(const ConstMember& member, const Project& of) {
    switch (member.field->kind) {
    case Kind::compliance: {
        const auto& given = member.field->as<GivenCompliance>(member.owner);
        return std::holds_alternative<std::monostate>(given)
                   ? inputText(member.field->nullMeaning)
                   : byPlace(std::holds_alternative<ZoneCompliance>(given));
    }
    case Kind::optionalNumberList:
        return member.field->as<std::optional<std::vector<double>>>(member.owner)
                   ? byPlace(of.operation->travels)
                   : inputText(member.field->nullMeaning);
    case Kind::numberRows:
        return member.field->as<NumberRows>(member.owner) ? byPlace(of.operation->travels)
                                                          : inputText(member.field->nullMeaning);
    default: return valueText(*member.field, member.owner);
    }
}

/// Adds the axial feeds, stage by stage, if a traverse gave them to stages without one.
void addAxialFeeds(const Project& before, const Project& after, QStringList& changes) {
    const StageFeed* const axial = after.operation->axial();
    const bool areSet = axial && !before.operation->axial()
                        && std::ranges::any_of(before.cycle->stages, [axial](const Stage& stage) {
                               return !(stage.*axial->value);
                           });
    if (!areSet) {
        return;
    }
    const Field& row = *tableOf<Stage>().find(axial->key);
    QStringList feeds;
    for (const Stage& stage : after.cycle->stages) {
        feeds += valueText(row, &stage);
    }
    changes += QStringLiteral("%1: %2 → %3")
                   .arg(inputText(row.label), inputText(row.nullMeaning),
                        feeds.join(QStringLiteral(", ")));
}

} // namespace

QStringList changesOfOperation(const Project& before, const Project& after) {
    QStringList changes;
    for (const char* path :
         {"/part/length_mm", "/machine/overrun_entry_mm", "/machine/overrun_exit_mm",
          "/machine/compliance_mm_per_n", "/gauge/section", "/gauge/position_mm",
          "/gauge/compliance_mm_per_n", "/least_steps", "/part/zone_stock_mm",
          "/part/zone_runout_mm", "/machine/zone_compliance", "/batch/zone_stock_mm",
          "/machine/form/roundness_um", "/machine/form/runout_um", "/batch/zone_runout_mm",
          "/batch/zone_compliance"}) {
        const ConstMember was = findMember(before, path);
        const QString old = switchedText(was, before);
        const QString made = switchedText(findMember(after, path), after);
        if (old != made) {
            changes += QStringLiteral("%1: %2 → %3").arg(inputText(was.field->label), old, made);
        }
    }
    addAxialFeeds(before, after, changes);
    return changes;
}

} // namespace sparkout
