// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/table_file.h"

#include "core/version.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/table/sheet.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>

#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

struct TableFile {
    Q_DECLARE_TR_FUNCTIONS(TableFile)
};

/// The sheet if it has more rows than a workbook can have.
std::optional<Sheet> longSheet(const CsvTable& table, const QString& name) {
    if (table.rows.size() + 2 <= xlsxRows) { // plus names and units
        return std::nullopt;
    }
    const std::vector<Sheet> sheets = sheetsOf(table, name);
    const Sheet* sheet = sheetTooLong(sheets);
    return sheet ? std::optional(*sheet) : std::nullopt;
}

void sayTooLong(QWidget* window, const Sheet& sheet) {
    QMessageBox box(QMessageBox::Information, TableFile::tr("Too many rows"),
                    tooLongText(sheet.name, sheet.rows), QMessageBox::Ok, window);
    box.setTextFormat(Qt::PlainText);
    box.exec();
}

} // namespace

QString tooLongText(const QString& sheet, std::size_t rows) {
    return TableFile::tr("“%1” would have %2 rows; a worksheet has at most %3, including the head. "
                         "It can be saved in full as CSV.")
        .arg(sheet, QLocale().toString(static_cast<qulonglong>(rows)),
             QLocale().toString(static_cast<qulonglong>(xlsxRows)));
}

QString tableFormatText(TableFormat format) {
    switch (format) {
    case TableFormat::xlsx: return TableFile::tr("&XLSX workbook…");
    case TableFormat::csvRussian:
        return TableFile::tr("&Russian Excel: semicolons, decimal commas…");
    case TableFormat::csvEnglish: return TableFile::tr("&English: commas, decimal points…");
    }
    return {};
}

QString tableFormatHint(TableFormat format) {
    return format == TableFormat::xlsx
               ? TableFile::tr("Numbers with all their digits, units in a separate row")
               : TableFile::tr(
                   "Headers in the language of the window; Excel opens the file directly");
}

QString tableFormatFilter(TableFormat format) {
    switch (format) {
    case TableFormat::xlsx: return TableFile::tr("XLSX workbooks (*.xlsx)");
    case TableFormat::csvRussian:
        return TableFile::tr("CSV tables: semicolons, decimal commas, UTF-8 (*.csv)");
    case TableFormat::csvEnglish:
        return TableFile::tr("CSV tables: commas, decimal points, UTF-8 (*.csv)");
    }
    return {};
}

QString tableFormatSuffix(TableFormat format) {
    return format == TableFormat::xlsx ? QStringLiteral("xlsx") : QStringLiteral("csv");
}

CsvDialect dialectOf(TableFormat format) {
    return format == TableFormat::csvRussian ? CsvDialect::russianExcel : CsvDialect::english;
}

QString programText() {
    return QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version));
}

bool saveTable(QWidget* window, Settings* settings, NamedTable named, TableFormat format) {
    const QString name = named.heading.value(0);
    const auto table = std::make_shared<const CsvTable>(std::move(named.table));
    SaveRequest request{TableFile::tr("Save the data"),
                        fileNameOf({named.heading.value(1), name}),
                        tableFormatSuffix(format),
                        tableFormatFilter(format),
                        {},
                        {}};
    if (format == TableFormat::xlsx) {
        if (const auto sheet = longSheet(*table, name)) {
            sayTooLong(window, *sheet);
            return false;
        }
        request.longWork = [table, name, title = named.heading.join(QStringLiteral(" — "))](
                               const KeepGoing& keepGoing) {
            return xlsxBytes({title, {}, programText(), sheetsOf(*table, name)}, keepGoing);
        };
    } else {
        request.prepare = [table, format]() -> std::function<QByteArray()> {
            return [table, format] { return csvBytes(*table, dialectOf(format)); };
        };
    }
    return saveWithDialog(window, settings, request);
}

} // namespace sparkout
