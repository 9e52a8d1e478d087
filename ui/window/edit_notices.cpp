// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/edit_notices.h"

#include "core/project/part.h"
#include "core/study/operation.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/text/field_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

const QString operationKey = QStringLiteral("operation"), lawsKey = QStringLiteral("laws");

QString sentence(const Project& before, const Project& after) {
    const bool shortened = after.part->length_mm < before.part->length_mm;
    return !after.operation->travels && shortened
               ? QCoreApplication::translate("OperationNotice",
                                             "A plunge grinds only the length that the wheel "
                                             "covers. These inputs changed with the operation: %1.")
               : QCoreApplication::translate("OperationNotice",
                                             "These inputs changed with the operation: %1.");
}

QString lawsText(const std::vector<FactorKind>& moved) {
    QStringList factors;
    for (const FactorKind kind : moved) {
        factors += inputText(factorLabel(kind));
    }
    return QCoreApplication::translate("LawsNotice",
                                       "Distributions of the batch follow this edit: %1.")
        .arg(factors.join(QStringLiteral(", ")));
}

} // namespace

void showOperationNotice(NoticeBar& notices, const Project& before, const Project& after) {
    if (before.operation == after.operation) {
        return;
    }
    notices.remove(operationKey);
    if (changesOfOperation(before, after).isEmpty()) {
        return;
    }
    const auto text = [before, after] {
        return sentence(before, after)
            .arg(changesOfOperation(before, after).join(QStringLiteral("; ")));
    };
    notices.add({operationKey, Mark::warning, text, {}});
}

void showLawsNotice(NoticeBar& notices, const std::vector<FactorKind>& moved) {
    if (moved.empty()) {
        notices.remove(lawsKey);
    } else if (notices.textOf(lawsKey) != lawsText(moved)) { // not again with each letter typed
        notices.add({lawsKey, Mark::none, [moved] { return lawsText(moved); }, {}});
    }
}

void dropEditNotices(NoticeBar& notices) {
    notices.remove(operationKey);
    notices.remove(lawsKey);
}

} // namespace sparkout
