// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/packs/pack_commands.h"

#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/pack/pack.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/file_dialog.h"
#include "ui/packs/pack_export_dialog.h"
#include "ui/packs/pack_import_dialog.h"
#include "ui/session/background.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QMessageBox>

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

const QString suffix = QStringLiteral("sparkout-pack");

} // namespace

PackCommands::PackCommands(Settings& settings, QWidget* window)
    : QObject(window)
    , m_settings(settings)
    , m_window(window)
    , m_questions(m_file, m_wait, window) {}

bool PackCommands::isPack(const QString& path) {
    return path.endsWith(u'.' + suffix, Qt::CaseInsensitive);
}

void PackCommands::exportPack() {
    PackExportDialog dialog(m_settings, m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const Pack pack = dialog.pack();
    const QString title = QString::fromStdString(pack.title);
    SaveRequest request{tr("Export a pack"),
                        fileNameOf({title.isEmpty() ? tr("Pack") : title}),
                        suffix,
                        tr("Packs (*.sparkout-pack)"),
                        {}};
    request.content = [&pack]() -> std::optional<std::string> {
        std::string text = writePack(pack);
        return readPack(text).pack ? std::optional(std::move(text)) : std::nullopt;
    };
    request.guard = &m_questions;
    (void)saveWithDialog(m_window, &m_settings, request);
    m_file.dropClaim();
    m_file.unlock(); // nobody works in a pack
}

void PackCommands::importPack() {
    const QString path =
        FileDialog::openPath(m_window, tr("Import a pack"), m_settings.lastFolder(),
                             tr("Packs (*.sparkout-pack);;All files (*)"));
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void PackCommands::importFile(const QString& path) {
    std::variant<std::string, FileError> bytes;
    ReadPack read;
    runAside([&] {
        bytes = readFile(systemPath(path), limits::fileBytes);
        if (const auto* text = std::get_if<std::string>(&bytes)) {
            read = readPack(*text);
        }
    });
    if (const auto* error = std::get_if<FileError>(&bytes)) {
        QMessageBox box(QMessageBox::Warning, tr("Import a pack"), readErrorText(*error),
                        QMessageBox::Ok, m_window);
        box.setTextFormat(Qt::PlainText);
        box.exec();
        return;
    }
    const QString file = QFileInfo(path).fileName();
    if (!read.pack) {
        FaultsDialog(file, read.issues, m_window).exec();
        return;
    }
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    if (PackImportDialog(*read.pack, m_settings, m_window).exec() != QDialog::Accepted) {
        return;
    }
    if (auto* notices = m_window->findChild<NoticeBar*>()) {
        notices->add({QStringLiteral("packTaken"),
                      Mark::none,
                      [file] { return tr("Imported from “%1”.").arg(printableText(file)); },
                      {}});
    }
}

} // namespace sparkout
