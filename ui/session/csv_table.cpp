// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/csv_table.h"

#include <cmath>

namespace sparkout {

namespace {

/// The shortest digits that read back as the same number.
QString numberText(double value, QChar decimal) {
    QString text = QString::number(value, 'g', QLocale::FloatingPointShortest);
    return text.replace(u'.', decimal);
}

QString quoted(const QString& text, QChar separator) {
    const bool plain = !text.contains(separator) && !text.contains(u'"') && !text.contains(u'\n')
                       && !text.contains(u'\r');
    if (plain) {
        return text;
    }
    QString inside = text;
    inside.replace(QStringLiteral("\""), QStringLiteral("\"\""));
    return u'"' + inside + u'"';
}

QString cellText(const CsvCell& cell, QChar decimal) {
    if (const auto* number = std::get_if<double>(&cell)) {
        return std::isfinite(*number) ? numberText(*number, decimal) : QString();
    }
    const auto* text = std::get_if<QString>(&cell);
    return text ? harmlessCell(*text) : QString();
}

QString csvLine(const std::vector<CsvCell>& cells, QChar separator, QChar decimal) {
    QStringList texts;
    for (const CsvCell& cell : cells) {
        texts << quoted(cellText(cell, decimal), separator);
    }
    return texts.join(separator) + QStringLiteral("\r\n");
}

std::vector<CsvCell> headerCells(const CsvTable& table) {
    return {table.header.begin(), table.header.end()};
}

} // namespace

QString harmlessCell(const QString& text) {
    const bool formula = !text.isEmpty() && QStringView(u"=+-@\t\r").contains(text.front());
    return formula ? u'\'' + text : text;
}

QByteArray csvBytes(const CsvTable& table, CsvDialect dialect) {
    const bool russian = dialect == CsvDialect::russianExcel;
    const QChar separator = russian ? u';' : u',';
    const QChar decimal = russian ? u',' : u'.';
    QString text = csvLine(headerCells(table), separator, decimal);
    for (const std::vector<CsvCell>& row : table.rows) {
        text += csvLine(row, separator, decimal);
    }
    return "\xEF\xBB\xBF" + text.toUtf8();
}

QString tabSeparated(const CsvTable& table, const QLocale& locale) {
    const QChar decimal = locale.decimalPoint().front();
    const auto line = [decimal](const std::vector<CsvCell>& cells) {
        QStringList texts;
        for (const CsvCell& cell : cells) {
            // Tabs and line ends would tear the row apart.
            texts << cellText(cell, decimal).simplified();
        }
        return texts.join(u'\t') + u'\n';
    };
    QString text = line(headerCells(table));
    for (const std::vector<CsvCell>& row : table.rows) {
        text += line(row);
    }
    return text;
}

} // namespace sparkout
