// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table/csv_table.h"

#include "core/file/csv_line.h"
#include "ui/text/field_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

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

namespace {

struct OutputCells {
    Q_DECLARE_TR_FUNCTIONS(OutputCells)
};

void addIntervalHeads(QStringList& header, const QString& name) {
    header << OutputCells::tr("%1, 95 % from").arg(name)
           << OutputCells::tr("%1, 95 % to").arg(name);
}

void addNumber(std::vector<CsvCell>& cells, const std::optional<double>& number) {
    if (number) {
        cells.emplace_back(*number);
    } else {
        cells.emplace_back();
    }
}

} // namespace

void addEstimateHeads(QStringList& header, const QString& name) {
    header << name;
    addIntervalHeads(header, name);
}

void addIntervalCells(std::vector<CsvCell>& cells, const std::optional<Interval>& interval,
                      double factor) {
    addNumber(cells, interval ? std::optional(interval->low * factor) : std::nullopt);
    addNumber(cells, interval ? std::optional(interval->high * factor) : std::nullopt);
}

void addHeads(QStringList& header, const OutputRow& row, OutputKind kind, bool revolutions) {
    const QString name = outputName(row, revolutions);
    switch (kind) {
    case OutputKind::interval: addIntervalHeads(header, name); break;
    case OutputKind::estimate: addEstimateHeads(header, name); break;
    case OutputKind::share:
        header << name << OutputCells::tr("%1, share").arg(name);
        addIntervalHeads(header, name);
        break;
    default: header << name;
    }
}

void addCells(std::vector<CsvCell>& cells, const OutputRow& row, OutputKind kind,
              const OutputValue& value) {
    const std::optional<double> number = outputNumber(row, value);
    switch (kind) {
    case OutputKind::interval: {
        const auto* interval = std::get_if<Interval>(&value);
        addIntervalCells(cells, interval ? std::optional(*interval) : std::nullopt,
                         row.shownFactor);
        break;
    }
    case OutputKind::estimate: {
        const auto* estimate = std::get_if<Estimate>(&value);
        addNumber(cells, number);
        addIntervalCells(cells, estimate ? std::optional(estimate->interval) : std::nullopt,
                         row.shownFactor);
        break;
    }
    case OutputKind::share: {
        const auto* share = std::get_if<Share>(&value);
        addNumber(cells, share ? std::optional(static_cast<double>(share->count)) : std::nullopt);
        addNumber(cells, number);
        addIntervalCells(cells, share ? share->interval : std::nullopt);
        break;
    }
    default: addNumber(cells, number);
    }
}

} // namespace sparkout
