// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "ui/session/file_guard.h"
#include "ui/session/recovery_store.h"

#include <QCoreApplication>
#include <QObject>
#include <QStringList>

class QWidget;

namespace sparkout {

class DiskWait;
class Document;
class FileGuard;
class FileNotices;

/// Restores unsaved work left by a crash, or discarded a while ago.
class WorkRecovery {
    Q_DECLARE_TR_FUNCTIONS(WorkRecovery)

public:
    WorkRecovery(Document& document, FileGuard& guard, FileNotices& notices, DiskWait& wait,
                 QWidget* window);

    bool offer(bool alsoDiscarded); ///< true: the document is now such work

private:
    bool recover(const RecoveryItem& item);

    Document& m_document;
    FileGuard& m_guard;
    FileNotices& m_notices;
    DiskWait& m_wait;
    QWidget* m_window;
};

class NoticeBar;
class Settings;

/// Notices about files: opened read-only, changed by another program, recovered, not protected.
class FileNotices : public QObject {
    Q_OBJECT

public:
    FileNotices(Document& document, const Settings& settings, FileGuard& guard, NoticeBar& bar,
                QWidget* window);

    void showOpened(const Issues& issues); ///< about the file that was read
    void showReadOnly();
    void showRecovered(const RecoveryHeader& header);
    void showDamagedSettings();
    void followSaved();
    void followDisk(); ///< the document equals its file

signals:
    void saveWanted();
    void saveAsWanted();
    void reloadWanted();

private:
    void removeAll(const QStringList& keys);
    void showStrangeLock();
    void showChangedOnDisk(const DiskState& state);
    void showAutosaveFailed(const FileError& error);
    void showRefusedSettings(const FileError& error);

    Document& m_document;
    const Settings& m_settings;
    FileGuard& m_guard;
    NoticeBar& m_bar;
    QWidget* m_window;
};

} // namespace sparkout
