// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/report.h"

#include "ui/text/number_text.h"

#include <QCoreApplication>

namespace sparkout::report {

namespace {
struct TableText {
    Q_DECLARE_TR_FUNCTIONS(TableText)
};
} // namespace

QString captionOf(const Table& table) {
    return table.caption.isEmpty()
               ? QString()
               : TableText::tr("Table %1 — %2").arg(QString::number(table.number), table.caption);
}

QString continuationOf(const Table& table) {
    return table.caption.isEmpty() ? QString()
                                   : TableText::tr("Table %1 continued").arg(table.number);
}

QString Report::origin() const {
    QStringList parts{program, file, dateText(date)};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

} // namespace sparkout::report
