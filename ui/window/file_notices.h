// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "ui/files/file_guard.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace sparkout {

class Document;
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
