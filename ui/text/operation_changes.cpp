// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/operation_changes.h"

#include "core/project/member.h"
#include "ui/text/defaults.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

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

QStringList changesOfOperation(const Project& before, const Project& after) {
    QStringList changes;
    for (const char* path :
         {"/part/length_mm", "/wheel/width_mm", "/machine/overrun_entry_mm",
          "/machine/overrun_exit_mm", "/machine/compliance_mm_per_n", "/gauge/section",
          "/gauge/position_mm", "/gauge/compliance_mm_per_n", "/least_steps"}) {
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
