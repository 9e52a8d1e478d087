// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/files/file_guard.h"
#include "ui/window/dialogs/file_questions.h"

#include <QObject>

#include <functional>
#include <optional>
#include <utility>

class QWidget;

namespace sparkout {

class Document;
class NoticeBar;
class RecentFilesMenu;
class Settings;

/// The commands that deal with files, with their questions, messages and notices.
class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Document& document, Settings& settings, QWidget* window);
    ~FileCommands() override;

    /// From now on files are locked and watched, and recovery files and earlier versions are kept
    /// in this folder. Without it nothing but the saved file is written.
    void protect(const QString& stateFolder, Autosave::Times times = {});
    /// Where the texts come from that fields refused and no file holds.
    void askRefusedTexts(std::function<QStringList()> texts) { m_refused = std::move(texts); }
    /// What the program begins with: unsaved work that was left is offered, then FILE is opened.
    void start(const QString& file);

    void startNew(Operation operation);
    void open();
    bool openFile(const QString& path);    ///< without asking for unsaved changes
    void openInstead(const QString& path); ///< asks first
    void openExample();
    void openEarlierVersion();
    void recoverWork();
    bool save();
    bool saveAs();
    /// Asks what to do with unsaved changes and refused texts; false when the user wants to stay.
    [[nodiscard]] bool mayDiscard();
    /// The same before the window closes; the changes that are given up stay recoverable a while.
    [[nodiscard]] bool mayClose();

    [[nodiscard]] FileGuard& guard() { return m_guard; }
    [[nodiscard]] NoticeBar& notices() { return *m_notices; }
    [[nodiscard]] RecentFilesMenu& recentFiles() { return *m_recent; }

signals:
    void saved();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Opening { write, readOnly, copy };

    // file_commands.cpp
    [[nodiscard]] std::optional<Opening> wayToOpen(const QString& path);
    void take(LoadedProject loaded, const QString& path, Opening opening);
    bool openAsCopy(const QString& path);
    void remember(const QString& path);
    void aside(const std::function<void()>& work);

    // file_commands_save.cpp
    bool saveTo(const QString& path);
    [[nodiscard]] SaveAnswer clearTheWay(const QString& path);
    [[nodiscard]] QString suggestedPath() const;
    void reload();

    // file_notices.cpp
    bool offerRecovery(bool alsoDiscarded);
    bool recover(const RecoveryItem& item);
    void connectNotices();
    void tellSameAsDisk();
    void tellOpened(const Issues& issues);
    void tellReadOnly();
    void tellStrangeLock();
    void tellChangedOnDisk(const DiskState& state);
    void tellRecovered(const RecoveryHeader& header);
    void tellDamagedSettings();
    void tellAutosaveFailed(const FileError& error);

    Document& m_document;
    Settings& m_settings;
    QWidget* m_window;
    NoticeBar* m_notices;
    RecentFilesMenu* m_recent;
    std::function<QStringList()> m_refused = [] { return QStringList(); };
    QString m_linksAccepted; ///< the file whose other names may keep the old text
    bool m_busy = false;     ///< a disk is being waited for
    FileGuard m_guard;
};

} // namespace sparkout
