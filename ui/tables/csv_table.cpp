// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/csv_table.h"

#include "core/tables/csv_line.h"
#include "ui/text/texts.h"

namespace sparkout {

namespace {

/// The pasted form of a cell: a spreadsheet interprets tabs and line ends as those of the table.
QString pastedCell(const CsvCell& cell, const TableDialect& dialect) {
    if (const auto* number = std::get_if<double>(&cell)) {
        return QString::fromStdString(CsvLine(dialect).number(*number).end({}));
    }
    const auto* const text = std::get_if<QString>(&cell);
    if (!text) {
        return {};
    }
    const QString plain = harmlessText(*text).simplified();
    return readsAsFormula(text->toStdString()) || readsAsFormula(plain.toStdString())
               ? u'\'' + plain
               : plain;
}

/// Headings have plain spaces, since spreadsheets and programs look them up.
std::vector<CsvCell> headerCells(const CsvTable& table) {
    QStringList names = table.header;
    names.replaceInStrings(QString(QChar::Nbsp), QStringLiteral(" "));
    return {names.cbegin(), names.cend()};
}

} // namespace

TableDialect tableDialect(CsvDialect dialect) {
    return dialect == CsvDialect::russianExcel ? TableDialect{';', ','} : TableDialect{',', '.'};
}

QByteArray csvBegin() {
    return "\xEF\xBB\xBF";
}

QByteArray csvLine(const std::vector<CsvCell>& cells, CsvDialect dialect) {
    CsvLine line(tableDialect(dialect));
    for (const CsvCell& cell : cells) {
        if (const auto* number = std::get_if<double>(&cell)) {
            line.number(*number);
        } else {
            const auto* const text = std::get_if<QString>(&cell);
            line.text(text ? text->toStdString() : std::string());
        }
    }
    return QByteArray::fromStdString(line.end("\r\n"));
}

QByteArray csvBytes(const CsvTable& table, CsvDialect dialect) {
    QByteArray bytes = csvBegin() + csvLine(headerCells(table), dialect);
    for (const std::vector<CsvCell>& row : table.rows) {
        bytes += csvLine(row, dialect);
    }
    return bytes;
}

QString tabSeparated(const CsvTable& table, const QLocale& locale) {
    const TableDialect dialect{'\t', locale.decimalPoint() == u"," ? ',' : '.'};
    const auto line = [&dialect](const std::vector<CsvCell>& cells) {
        QStringList texts;
        for (const CsvCell& cell : cells) {
            texts << pastedCell(cell, dialect);
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
