// SPDX-License-Identifier: GPL-3.0-or-later
// FileCommands: what it tells without a question, and what a crash left.
#include "ui/dialogs/faults_dialog.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/recovery_dialog.h"
#include "ui/window/file_commands.h"
#include "ui/window/notice_bar.h"

#include "core/format/project_file.h"
#include "ui/text/file_error_text.h"

#include <QFileInfo>
#include <QLocale>

#include <cstring>

namespace sparkout {

namespace {

const QString readOnlyKey = QStringLiteral("readOnly");
const QString diskKey = QStringLiteral("disk");
const QString recoveredKey = QStringLiteral("recovered");
const QString keptRunsKey = QStringLiteral("keptRuns");
const QString autosaveKey = QStringLiteral("autosave");
const QString settingsKey = QStringLiteral("settings");
const QString lockKey = QStringLiteral("lock");

QString nameOf(const QString& path) {
    return printableText(QFileInfo(path).fileName());
}

} // namespace

void FileCommands::connectNotices() {
    connect(&m_document, &Document::replaced, this, [this] {
        for (const QString& key : {readOnlyKey, diskKey, recoveredKey, keptRunsKey}) {
            m_notices->remove(key);
        }
        tellStrangeLock();
    });
    connect(this, &FileCommands::saved, this, [this] {
        for (const QString& key : {readOnlyKey, diskKey, recoveredKey}) {
            m_notices->remove(key);
        }
        tellStrangeLock();
    });
    connect(&m_guard, &FileGuard::changedOnDisk, this, &FileCommands::tellChangedOnDisk);
    connect(&m_guard, &FileGuard::restoredOnDisk, this, [this] { m_notices->remove(diskKey); });
    connect(&m_guard, &FileGuard::autosaveFailed, this, &FileCommands::tellAutosaveFailed);
    connect(&m_guard, &FileGuard::autosaved, this, [this] { m_notices->remove(autosaveKey); });
}

void FileCommands::tellSameAsDisk() {
    m_notices->remove(diskKey);
}

void FileCommands::tellOpened(const Issues& issues) {
    if (m_document.readOnly()) {
        tellReadOnly();
    }
    Issues faults;
    for (const Issue& issue : issues) {
        if (issue.severity == Severity::error && issue.path.starts_with("/runs/")) {
            faults.push_back(issue);
        }
    }
    m_notices->remove(keptRunsKey);
    if (faults.empty()) {
        return;
    }
    const QString path = m_document.filePath();
    m_notices->add({keptRunsKey,
                    Mark::warning,
                    [] {
                        return tr("Kept runs of this file hold inputs that this version refuses. "
                                  "They stay in the file as they are, but cannot be computed "
                                  "again.");
                    },
                    {{[] { return tr("Show…"); },
                      [this, path, faults] {
                          FaultsDialog(path, faults, m_window, FaultsDialog::File::opened).exec();
                      }}}});
}

void FileCommands::tellReadOnly() {
    const QString name = nameOf(m_document.filePath());
    m_notices->add(
        {readOnlyKey,
         Mark::none,
         [name] { return tr("“%1” is open read-only. Saving asks for another name.").arg(name); },
         {{[] { return tr("Save as…"); }, [this] { saveAs(); }}}});
}

void FileCommands::tellStrangeLock() {
    const QString strange = m_guard.strangeLock();
    m_notices->remove(lockKey);
    if (!strange.isEmpty()) {
        m_notices->add({lockKey,
                        Mark::warning,
                        [strange] {
                            return tr("The file is not locked against other users: “%1” stands "
                                      "where its lock belongs and is not a lock file. It was "
                                      "left as it is.")
                                .arg(printableText(strange));
                        },
                        {}});
    }
}

void FileCommands::tellChangedOnDisk(const DiskState& state) {
    const QString name = nameOf(m_document.filePath());
    const Notice::Button reloadButton{[] { return tr("Reload"); }, [this] { reload(); }};
    if (state.kind != DiskState::Kind::file) {
        m_document.markUnsaved();
        m_notices->add({diskKey,
                        Mark::warning,
                        [name] {
                            return tr("“%1” was removed or renamed by another program. The project "
                                      "now is in this window only.")
                                .arg(name);
                        },
                        {{[] { return tr("Save"); }, [this] { save(); }}}});
    } else if (m_document.modified()) {
        m_notices->add({diskKey,
                        Mark::warning,
                        [name] {
                            return tr("“%1” was changed by another program while it has unsaved "
                                      "changes here. Saving will ask which version counts.")
                                .arg(name);
                        },
                        {reloadButton}});
    } else {
        m_notices->add(
            {diskKey,
             Mark::warning,
             [name] { return tr("“%1” was changed by another program. Reload it?").arg(name); },
             {reloadButton,
              {[] { return tr("Keep mine"); }, [this] { m_document.markUnsaved(); }}}});
    }
}

void FileCommands::tellRecovered(const RecoveryHeader& header) {
    m_notices->add(
        {recoveredKey,
         Mark::none,
         [header] {
             const QString when = momentText(header.when.toLocalTime());
             return header.path.isEmpty()
                        ? tr("This is recovered work of %1. It is not saved yet.").arg(when)
                        : tr("This is recovered work of %1 on “%2”. It is not saved "
                             "yet; the file is as it was.")
                              .arg(when, nameOf(header.path));
         },
         {{[] { return tr("Save"); }, [this] { save(); }}}});
}

void FileCommands::tellDamagedSettings() {
    const QString aside = m_settings.damaged();
    if (!aside.isEmpty()) {
        m_notices->add({settingsKey,
                        Mark::warning,
                        [aside] {
                            return tr("The settings file was damaged and is kept as %1. The "
                                      "settings are the default ones.")
                                .arg(printableText(aside));
                        },
                        {}});
    }
    if (const auto& error = m_settings.unreadable()) {
        m_notices->add(
            {settingsKey,
             Mark::warning,
             [error = *error] {
                 if (error.step == FileStep::backup) {
                     return tr("The settings file is damaged and could not be put aside (%1): %2. "
                               "It is left as it is; the settings are the default ones, and "
                               "changes of them are not kept.")
                         .arg(QString::fromLocal8Bit(std::strerror(error.systemError)),
                              printableText(QString::fromStdString(error.path)));
                 }
                 return tr("The settings are the default ones: %1").arg(readErrorText(error));
             },
             {}});
    }
}

void FileCommands::tellAutosaveFailed(const FileError& error) {
    m_notices->add(
        {autosaveKey,
         Mark::warning,
         [error] {
             return tr("Unsaved work is not protected from a crash: %1").arg(saveErrorText(error));
         },
         {}});
}

void FileCommands::recoverWork() {
    if (mayDiscard()) {
        offerRecovery(true);
    }
}

bool FileCommands::offerRecovery(bool alsoDiscarded) {
    const RecoveryStore* store = m_guard.recovery();
    if (store == nullptr) {
        return false;
    }
    std::vector<RecoveryItem> items;
    bool offeredElsewhere = false;
    aside([&] {
        items = store->left(&offeredElsewhere);
        if (alsoDiscarded) {
            for (RecoveryItem& item : store->discarded()) {
                items.push_back(std::move(item));
            }
        }
    });
    if (items.empty()) {
        if (alsoDiscarded) {
            showFailure(m_window, tr("Recover work"),
                        offeredElsewhere ? RecoveryDialog::offeredElsewhereText()
                                         : tr("No unsaved work was found."));
        }
        return false;
    }
    RecoveryDialog dialog(*store, std::move(items), offeredElsewhere, m_window);
    const bool accepted = dialog.exec() == QDialog::Accepted;
    const auto chosen = dialog.chosen();
    return accepted && chosen && recover(*chosen);
}

bool FileCommands::recover(const RecoveryItem& item) {
    std::variant<std::string, FileError> read;
    RecoveryContent content;
    aside([&] {
        read = readFile(systemPath(item.file), limits::fileBytes + (64u << 10));
        if (const auto* text = std::get_if<std::string>(&read)) {
            content = readRecovery(*text);
        }
    });
    if (!content.project) { // it was whole when it was listed
        const auto* error = std::get_if<FileError>(&read);
        showFailure(m_window, tr("The file was not opened"),
                    error ? readErrorText(*error)
                          : tr("“%1” is damaged.").arg(printableText(item.file)));
        return false;
    }
    // Without a lock of its own the work goes on in another recovery file; this one stays.
    const RecoveryStore& store = *m_guard.recovery();
    RecoveryClaimPtr claim = store.claim(item);
    if (!claim && store.inUse(item)) {
        showFailure(m_window, tr("The file was not opened"),
                    tr("Another window has recovered this work meanwhile."));
        return false;
    }
    const RecoveryHeader& header = content.header;
    const bool readOnly =
        !header.path.isEmpty()
        && (m_guard.claim(header.path) != FileGuard::Access::write || header.readOnly);
    m_document.recover(std::move(*content.project), header.path, header.diskHash, readOnly);
    m_guard.adoptRecovery(std::move(claim));
    if (readOnly) {
        tellReadOnly();
    }
    tellRecovered(header);
    return true;
}

} // namespace sparkout
