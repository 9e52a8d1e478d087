// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/part_rows.h"

#include "core/study/part_rows_file.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <thread>

namespace sparkout {

namespace {

struct PartRows {
    Q_DECLARE_TR_FUNCTIONS(PartRows)
};

PartTable::Dialect dialectOfParts(TableFormat format) {
    const bool russian = format == TableFormat::csvRussian;
    return {tableDialect(russian ? CsvDialect::russianExcel : CsvDialect::english),
            csvBegin().toStdString(),
            "\r\n",
            {PartRows::tr("finished").toStdString(),
             PartRows::tr("does not reach size").toStdString(),
             PartRows::tr("strips stay uncut").toStdString()},
            PartRows::tr("yes").toStdString(),
            PartRows::tr("no").toStdString(),
            1};
}

std::vector<std::string> headOfParts(const PartColumns& columns) {
    QStringList names{PartRows::tr("Part"), PartRows::tr("State"), PartRows::tr("Good"),
                      PartRows::tr("Minimum margin, of its limit")};
    for (const GivenFactor& factor : columns.factors) {
        names << BatchText::factorAxis(factor);
    }
    for (const Characteristic& of : columns.characteristics) {
        names << QStringLiteral("%1, %2").arg(BatchText::full(of), unitText(of.unit));
    }
    for (const ConstraintKind kind : columns.requirements) {
        names << PartRows::tr("%1: met", "a requirement").arg(Names::constraint(kind));
    }
    std::vector<std::string> head;
    for (const QString& name : names) {
        head.push_back(name.toStdString());
    }
    return head;
}

bool writeRows(const Project& project, TableFormat format, const std::filesystem::path& path,
               const KeepGoing& keepGoing, const std::stop_token& stop,
               std::optional<FileError>& error) {
    PartRowsFile file(path, SafeFileWriter::Existing::replaced, // the dialog has asked before
                      {dialectOfParts(format), headOfParts});
    BatchOptions options;
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
    options.stop = stop;
    const bool written = file.runBatch(project, options, keepGoing);
    error = file.error();
    return written;
}

} // namespace

bool savePartRows(QWidget* window, Settings* settings, const Project& project, TableFormat format) {
    SaveRequest request;
    request.title = PartRows::tr("All parts of the batch");
    request.name = fileNameOf({exampleTitle(project.title), request.title});
    request.suffix = tableFormatSuffix(format);
    request.filter = tableFormatFilter(format);
    request.stream = [&project, format](const std::filesystem::path& path,
                                        const KeepGoing& keepGoing, const std::stop_token& stop,
                                        std::optional<FileError>& error) {
        return writeRows(project, format, path, keepGoing, stop, error);
    };
    return saveWithDialog(window, settings, request);
}

} // namespace sparkout
