// SPDX-License-Identifier: GPL-3.0-or-later
// FileCommands: what saves.
#include "ui/dialogs/faults_dialog.h"
#include "ui/session/document.h"
#include "ui/session/program_log.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"
#include "ui/window/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

namespace sparkout {

namespace {

const QString suffix = QStringLiteral(".sparkout");

} // namespace

bool FileCommands::save() {
    return m_document.filePath().isEmpty() || m_document.readOnly() ? saveAs()
                                                                    : saveTo(m_document.filePath());
}

bool FileCommands::saveAs() {
    QString path = QFileDialog::getSaveFileName(m_window, tr("Save the project"), suggestedPath(),
                                                tr("Sparkout projects (*.sparkout)"));
    if (path.isEmpty()) {
        return false;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += suffix;
        if (QFileInfo::exists(path) && !mayReplace(m_window, path)) {
            return false;
        }
    }
    return saveTo(path);
}

/// Everything that may speak against writing there, asked of the user.
SaveAnswer FileCommands::clearTheWay(const QString& path) {
    if (m_guard.claim(path) == FileGuard::Access::conflict) {
        const SaveAnswer answer = askSaveLocked(m_window, path, m_guard.holder());
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        (void)m_guard.takeOver();
    }
    if (const auto state = m_guard.changedOutside(path)) {
        const SaveAnswer answer =
            askChangedOutside(m_window, path, state->kind == DiskState::Kind::missing);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
    }
    if (const std::uint64_t links = linkCount(path); links > 1 && m_linksAccepted != path) {
        const SaveAnswer answer = askHardLinks(m_window, path, links);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        m_linksAccepted = path;
    }
    return SaveAnswer::proceed;
}

bool FileCommands::saveTo(const QString& path) {
    const SaveAnswer answer = clearTheWay(path);
    if (answer != SaveAnswer::proceed) {
        m_guard.dropClaim();
        if (answer == SaveAnswer::reload) {
            reload();
        }
        return answer == SaveAnswer::elsewhere && saveAs();
    }
    std::optional<FileError> error;
    const auto attempt = [&] {
        m_busy = true;
        error = m_guard.save(path);
        m_busy = false;
        return !error;
    };
    while (!attempt()) {
        const FailureAnswer next = askSaveFailed(m_window, *error);
        if (next != FailureAnswer::again) {
            m_guard.dropClaim();
            return next == FailureAnswer::elsewhere && saveAs();
        }
    }
    remember(path);
    ProgramLog::note(tr("Saved: %1").arg(printableText(path)));
    emit saved();
    return true;
}

/// The history keeps what was in the window.
void FileCommands::reload() {
    const QString path = m_document.filePath();
    LoadedProject loaded;
    aside([&] { loaded = loadProject(path); });
    if (loaded.project) {
        m_document.reload(std::move(*loaded.project), loaded.hash);
        m_guard.followDisk();
        tellSameAsDisk();
        tellOpened(loaded.issues);
    } else if (loaded.error) {
        showFailure(m_window, tr("The file was not opened"), readErrorText(*loaded.error));
    } else {
        FaultsDialog(path, loaded.issues, m_window).exec();
    }
}

QString FileCommands::suggestedPath() const {
    const QString path = m_document.filePath();
    if (!path.isEmpty() && !m_document.readOnly()) {
        return path;
    }
    if (!path.isEmpty()) { // beside the original if the folder lets, else among the documents
        const QFileInfo file(path);
        const QString folder =
            QFileInfo(file.absolutePath()).isWritable()
                ? file.absolutePath()
                : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        return folder + u'/' + tr("%1 copy").arg(file.completeBaseName()) + suffix;
    }
    static const QRegularExpression unfit(QStringLiteral("[\\\\/:*?\"<>|\\x00-\\x1f]+"));
    QString name = QString::fromStdString(m_document.project().title).simplified();
    name.replace(unfit, QStringLiteral("_")).truncate(80);
    return m_settings.lastFolder() + u'/' + (name.isEmpty() ? tr("Untitled") : name) + suffix;
}

} // namespace sparkout
