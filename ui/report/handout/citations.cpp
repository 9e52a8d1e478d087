// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/citations.h"

#include "ui/report/parts/cell_text.h"
#include "ui/text/source_names.h"

namespace sparkout::report {

QString Citations::cite(const QString& key) {
    if (!m_keys.contains(key)) {
        m_keys << key;
    }
    return QStringLiteral("[%1]").arg(key);
}

Table Citations::table() const {
    Table table;
    table.head = {tr("Key"), tr("Source")};
    table.texts = {true, true};
    for (const QString& key : m_keys) {
        table.rows.push_back({key, cell(sourceText(key.toStdString()))});
    }
    return table;
}

} // namespace sparkout::report
