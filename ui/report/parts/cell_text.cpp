// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/cell_text.h"

#include "ui/text/texts.h"

namespace sparkout::report {

QString manyLines(QString text) {
    text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
    QString kept;
    for (const QChar c : text) {
        const bool line = c == u'\n' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator;
        if (line) {
            kept += u'\n';
        } else if (c == u'\t' || c == u'\r') {
            kept += u' ';
        } else if (c >= u' ' && !c.isNonCharacter()) {
            kept += c;
        }
    }
    return kept;
}

QString oneLine(const std::string& text) {
    return manyLines(QString::fromStdString(text)).simplified();
}

QString cell(const QString& text) {
    return text.trimmed().isEmpty() ? QStringLiteral("–") : text;
}

QString withUnit(const QString& value, const char* unit) {
    return value + u'\u00a0' + unitText(unit);
}

QString requirementUnit(ConstraintKind kind) {
    const Requirement& row = requirementOf(kind);
    return cell(unitText(row.unitInFull ? row.unitInFull : row.unit));
}

} // namespace sparkout::report
