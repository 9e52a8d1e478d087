// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_notices.h"

#include "ui/dialogs/faults_dialog.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/files/file_guard.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

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

FileNotices::FileNotices(Document& document, const Settings& settings, FileGuard& guard,
                         NoticeBar& bar, QWidget* window)
    : m_document(document), m_settings(settings), m_guard(guard), m_bar(bar), m_window(window) {
    connect(&m_document, &Document::replaced, this, [this] {
        removeAll({readOnlyKey, diskKey, recoveredKey, keptRunsKey});
        showStrangeLock();
    });
    connect(&m_guard, &FileGuard::changedOnDisk, this, &FileNotices::showChangedOnDisk);
    connect(&m_guard, &FileGuard::restoredOnDisk, this, &FileNotices::followDisk);
    connect(&m_settings.file(), &SettingsFile::foundDamaged, this,
            &FileNotices::showDamagedSettings, Qt::QueuedConnection);
    connect(&m_settings.file(), &SettingsFile::refused, this, &FileNotices::showRefusedSettings);
    connect(&m_guard, &FileGuard::autosaveFailed, this, &FileNotices::showAutosaveFailed);
    connect(&m_guard, &FileGuard::autosaved, this, [this] { m_bar.remove(autosaveKey); });
}

void FileNotices::removeAll(const QStringList& keys) {
    for (const QString& key : keys) {
        m_bar.remove(key);
    }
}

void FileNotices::followSaved() {
    removeAll({readOnlyKey, diskKey, recoveredKey});
    showStrangeLock();
}

void FileNotices::followDisk() {
    m_bar.remove(diskKey);
}

void FileNotices::showOpened(const Issues& issues) {
    if (m_document.readOnly()) {
        showReadOnly();
    }
    Issues faults;
    for (const Issue& issue : issues) {
        if (issue.severity == Severity::error && issue.path.starts_with("/runs/")) {
            faults.push_back(issue);
        }
    }
    m_bar.remove(keptRunsKey);
    if (faults.empty()) {
        return;
    }
    const QString path = m_document.filePath();
    m_bar.add({keptRunsKey,
               Mark::warning,
               [] {
                   return tr("Kept runs of this file contain inputs that this version refuses. "
                             "They stay in the file unchanged but cannot be computed again.");
               },
               {{[] { return tr("Show…"); },
                 [this, path, faults] {
                     FaultsDialog(path, faults, m_window, FaultsDialog::File::opened).exec();
                 }}}});
}

void FileNotices::showReadOnly() {
    const QString name = nameOf(m_document.filePath());
    m_bar.add(
        {readOnlyKey,
         Mark::none,
         [name] { return tr("“%1” is open read-only. Saving asks for another name.").arg(name); },
         {{[] { return tr("Save as…"); }, [this] { emit saveAsWanted(); }}}});
}

void FileNotices::showStrangeLock() {
    const QString strange = m_guard.strangeLock();
    m_bar.remove(lockKey);
    if (!strange.isEmpty()) {
        m_bar.add({lockKey, Mark::warning, [strange] { return strangeLockText(strange); }, {}});
    }
}

void FileNotices::showChangedOnDisk(const DiskState& state) {
    const QString name = nameOf(m_document.filePath());
    const Notice::Button reloadButton{[] { return tr("Reload"); }, [this] { emit reloadWanted(); }};
    if (state.kind != DiskState::Kind::file) {
        m_document.markUnsaved();
        m_bar.add({diskKey,
                   Mark::warning,
                   [name] {
                       return tr("“%1” was removed or renamed by another program. The project "
                                 "now is in this window only.")
                           .arg(name);
                   },
                   {{[] { return tr("Save"); }, [this] { emit saveWanted(); }}}});
    } else if (m_document.modified()) {
        m_bar.add({diskKey,
                   Mark::warning,
                   [name] {
                       return tr("“%1” was changed by another program while it has unsaved "
                                 "changes here. Saving will ask which version counts.")
                           .arg(name);
                   },
                   {reloadButton}});
    } else {
        m_bar.add(
            {diskKey,
             Mark::warning,
             [name] { return tr("“%1” was changed by another program. Reload it?").arg(name); },
             {reloadButton,
              {[] { return tr("Keep mine"); }, [this] { m_document.markUnsaved(); }}}});
    }
}

void FileNotices::showRecovered(const RecoveryHeader& header) {
    m_bar.add({recoveredKey,
               Mark::none,
               [header] {
                   const QString when = momentText(header.when.toLocalTime());
                   return header.path.isEmpty()
                              ? tr("This is recovered work of %1. It is not saved yet.").arg(when)
                              : tr("This is recovered work of %1 on “%2”. It is not saved "
                                   "yet; the file is as it was.")
                                    .arg(when, nameOf(header.path));
               },
               {{[] { return tr("Save"); }, [this] { emit saveWanted(); }}}});
}

void FileNotices::showRefusedSettings(const FileError& error) {
    m_bar.add({settingsKey,
               Mark::error,
               [error] { return tr("The settings were not kept. %1").arg(saveErrorText(error)); },
               {}});
}

/// Includes those that another instance, or this one at its end, found damaged and put aside.
void FileNotices::showDamagedSettings() {
    if (const QStringList aside = m_settings.file().takeDamaged(); !aside.isEmpty()) {
        m_bar.add({settingsKey,
                   Mark::warning,
                   [aside] {
                       return tr("The settings file was damaged and is kept as %1. "
                                 "Settings that could not be read have their default values.")
                           .arg(printableText(aside.join(QStringLiteral(", "))));
                   },
                   {}});
    }
    if (const auto& error = m_settings.file().unreadable()) {
        m_bar.add({settingsKey,
                   Mark::warning,
                   [error = *error] {
                       if (error.step == FileStep::backup) {
                           return tr("The settings file is damaged and could not be renamed (%1): "
                                     "%2. It is left unchanged; the default settings are used, and "
                                     "changes to them are not saved.")
                               .arg(QString::fromLocal8Bit(std::strerror(error.systemError)),
                                    printableText(QString::fromStdString(error.path)));
                       }
                       return tr("The settings are the default ones: %1").arg(readErrorText(error));
                   },
                   {}});
    }
}

void FileNotices::showAutosaveFailed(const FileError& error) {
    m_bar.add(
        {autosaveKey,
         Mark::warning,
         [error] {
             return tr("Unsaved work is not protected from a crash: %1").arg(saveErrorText(error));
         },
         {}});
}

} // namespace sparkout
