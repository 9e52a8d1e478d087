// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_file.h"

#include "ui/dialogs/table_file.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace sparkout {

namespace {

struct ExportFile {
    Q_DECLARE_TR_FUNCTIONS(ExportFile)
};

TableFormat tableFormatOf(ExportFormat format) {
    switch (format) {
    case ExportFormat::csvRussian: return TableFormat::csvRussian;
    case ExportFormat::csvEnglish: return TableFormat::csvEnglish;
    default: return TableFormat::xlsx;
    }
}

} // namespace

bool ExportChoice::hasTrace() const {
    return format != ExportFormat::json
           && std::ranges::find(parts, ResultPart::trace) != parts.end();
}

QString exportSuffix(ExportFormat format) {
    return format == ExportFormat::json ? QStringLiteral("json")
                                        : tableFormatSuffix(tableFormatOf(format));
}

QString exportFilter(ExportFormat format) {
    return format == ExportFormat::json ? ExportFile::tr("JSON files (*.json)")
                                        : tableFormatFilter(tableFormatOf(format));
}

QString exportObstacle(const OutcomePtr& outcome, const ExportChoice& choice) {
    if (!choice.hasTrace()) {
        return {};
    }
    if (traceRows(*outcome) == 0) {
        return ExportFile::tr("There is no trace: the run has %1 rows and a trace at most %2, so "
                              "only the results are kept.")
            .arg(QLocale().toString(outcome->result.visits), QLocale().toString(maxRecordedVisits));
    }
    if (choice.format != ExportFormat::xlsx) {
        return {};
    }
    const Book book = bookOf(outcome, choice.parts);
    const Sheet* sheet = sheetTooLong(book.sheets);
    return sheet ? tooLongText(sheet->name, sheet->rows) : QString();
}

std::function<QByteArray(const KeepGoing&)> studyWork(const Study& study, ExportFormat format) {
    if (format == ExportFormat::xlsx) {
        return [book = studyBook(study)](const KeepGoing& keepGoing) {
            return xlsxBytes(book, keepGoing);
        };
    }
    return [sheet = studyMainSheet(study), dialect = dialectOf(tableFormatOf(format))](
               const KeepGoing& keepGoing) { return csvBytes(sheet, dialect, keepGoing); };
}

std::function<QByteArray(const KeepGoing&)> exportWork(const OutcomePtr& outcome,
                                                       const ExportChoice& choice) {
    switch (choice.format) {
    case ExportFormat::xlsx:
        return [book = bookOf(outcome, choice.parts)](const KeepGoing& keepGoing) {
            return xlsxBytes(book, keepGoing);
        };
    case ExportFormat::csvRussian:
    case ExportFormat::csvEnglish:
        return [sheet = partSheet(outcome, choice.parts.front()),
                dialect = dialectOf(tableFormatOf(choice.format))](const KeepGoing& keepGoing) {
            return csvBytes(sheet, dialect, keepGoing);
        };
    case ExportFormat::json: break;
    }
    return [outcome](const KeepGoing&) { return resultJsonBytes(*outcome); };
}

} // namespace sparkout
