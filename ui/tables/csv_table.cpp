// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/csv_table.h"

#include "core/printable.h"
#include "ui/text/texts.h"

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
    return text ? harmlessCell(harmlessText(*text)) : QString();
}

/// Spreadsheets and programs look the names up: they have plain spaces.
std::vector<CsvCell> headerCells(const CsvTable& table) {
    QStringList names = table.header;
    names.replaceInStrings(QString(QChar::Nbsp), QStringLiteral(" "));
    return {names.cbegin(), names.cend()};
}

} // namespace

QString harmlessCell(const QString& text) {
    return readsAsFormula(text.left(1).toStdString()) ? u'\'' + text : text;
}

QByteArray csvBegin() {
    return "\xEF\xBB\xBF";
}

QByteArray csvLine(const std::vector<CsvCell>& cells, CsvDialect dialect) {
    const bool russian = dialect == CsvDialect::russianExcel;
    const QChar separator = russian ? u';' : u',';
    const QChar decimal = russian ? u',' : u'.';
    QString line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line += (i > 0 ? QString(separator) : QString())
                + quoted(cellText(cells[i], decimal), separator);
    }
    return (line + QStringLiteral("\r\n")).toUtf8();
}

QByteArray csvBytes(const CsvTable& table, CsvDialect dialect) {
    QByteArray bytes = csvBegin() + csvLine(headerCells(table), dialect);
    for (const std::vector<CsvCell>& row : table.rows) {
        bytes += csvLine(row, dialect);
    }
    return bytes;
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
