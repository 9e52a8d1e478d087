// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/measured_import.h"

#include "core/file/safe_file.h"
#include "core/measured/measured_table.h"
#include "ui/dialogs/watched_work.h"
#include "ui/kit/file_dialog.h"
#include "ui/measured/import_dialog.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QMimeData>

#include <optional>
#include <utility>
#include <variant>

namespace sparkout {

MeasuredImport::MeasuredImport(Document& document, Settings& settings, QWidget* window)
    : QObject(window), m_document(document), m_settings(settings), m_window(window) {}

void MeasuredImport::say(const QString& title, const QString& text) {
    QMessageBox box(QMessageBox::Information, title, text, QMessageBox::Ok, m_window);
    box.setTextFormat(Qt::PlainText);
    box.exec();
}

void MeasuredImport::importFile() {
    const QString path =
        FileDialog::openPath(m_window, tr("Import measurements"), m_settings.lastFolder(),
                             tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (!path.isEmpty()) {
        importFrom(path);
    }
}

void MeasuredImport::importFrom(const QString& path) {
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    const QString name = QFileInfo(path).fileName();
    std::optional<FileError> error;
    MeasuredSource source;
    const bool isRead =
        runWatched(m_window, tr("Reading %1").arg(printableText(name)), [&](const KeepGoing&) {
            auto bytes = readFile(systemPath(path), limits::measuredBytes);
            if (const auto* fault = std::get_if<FileError>(&bytes)) {
                error = *fault;
            } else {
                source = {name, std::move(std::get<std::string>(bytes))};
            }
        });
    if (error) {
        say(tr("The file was not read"), readErrorText(*error));
    } else if (isRead) {
        take(std::move(source));
    }
}

void MeasuredImport::paste() {
    const QMimeData* const data = QGuiApplication::clipboard()->mimeData();
    QString text = data && data->hasText() ? data->text() : QString();
    if (text.trimmed().isEmpty()) {
        text = PastedCells::of(data).text();
    }
    if (text.trimmed().isEmpty()) {
        say(tr("Nothing to paste"),
            tr("The clipboard holds no table. Copy the cells of a spreadsheet with their headings "
               "first."));
        return;
    }
    take({{}, text.toStdString()});
}

void MeasuredImport::take(MeasuredSource source) {
    ImportDialog dialog(std::move(source), m_document.project(), m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    m_document.endMerge();
    m_document.edit(
        ImportDialog::withMeasured(m_document.project(), dialog.read(), dialog.replaces()),
        {"Edit", QT_TRANSLATE_NOOP("Edit", "Import measurements")});
    emit imported();
}

} // namespace sparkout
