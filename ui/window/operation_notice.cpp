// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/operation_notice.h"

#include "core/project/part.h"
#include "core/study/operation.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/text/field_text.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

const QString operationKey = QStringLiteral("operation");

QString sentence(const Project& before, const Project& after) {
    const bool shortened = after.part->length_mm < before.part->length_mm;
    return !after.operation->travels && shortened
               ? QCoreApplication::translate("OperationNotice",
                                             "A plunge grinds only the length that the wheel "
                                             "covers. These inputs changed with the operation: %1.")
               : QCoreApplication::translate("OperationNotice",
                                             "These inputs changed with the operation: %1.");
}

} // namespace

void showOperationNotice(NoticeBar& notices, const Project& before, const Project& after) {
    if (before.operation == after.operation) {
        return;
    }
    dropOperationNotice(notices);
    if (changesOfOperation(before, after).isEmpty()) {
        return;
    }
    const auto text = [before, after] {
        return sentence(before, after)
            .arg(changesOfOperation(before, after).join(QStringLiteral("; ")));
    };
    notices.add({operationKey, Mark::warning, text, {}});
}

void dropOperationNotice(NoticeBar& notices) {
    notices.remove(operationKey);
}

} // namespace sparkout
