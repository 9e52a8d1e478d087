// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/value_table.h"

#include <QStringList>

namespace sparkout {

QString ValueTable::asTsv() const {
    QStringList heads{corner};
    for (const ValueHead& column : columns) {
        heads << column.fullName();
    }
    if (!remarks.isEmpty()) {
        heads << remarks;
    }
    QString text = heads.join(u'\t') + u'\n';
    for (std::size_t row = 0; row < rows.size(); ++row) {
        QStringList line{rows[row].fullName()}, said;
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const ValueCell& cell = cells[row][column];
            line << cell.text;
            if (!cell.remark.isEmpty()) {
                said << QStringLiteral("%1: %2").arg(columns[column].fullName(), cell.remark);
            }
        }
        if (!remarks.isEmpty()) {
            line << said.join(QStringLiteral("; "));
        }
        text += line.join(u'\t') + u'\n';
    }
    return text;
}

} // namespace sparkout
