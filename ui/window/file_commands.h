// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/dialogs/file_questions.h"
#include "ui/session/file_guard.h"
#include "ui/window/file_notices.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <utility>

class QWidget;

namespace sparkout {

class Document;
class FileGuard;
class Settings;

/// Saves the document after asking the user about every obstacle.
class ProjectSaver : public QObject {
    Q_OBJECT

public:
    ProjectSaver(Document& document, const Settings& settings, FileGuard& guard,
                 GuardQuestions& questions, QWidget* window);

    bool save(); ///< to its file; asks for one if there is none that may be written
    bool saveAs();

signals:
    void saved(const QString& path);
    void reloadWanted(); ///< instead of saving: the file was changed by another program

private:
    bool isComplete(); ///< or shows why it cannot be saved
    bool saveTo(const QString& path);
    [[nodiscard]] QString suggestedPath() const;

    Document& m_document;
    const Settings& m_settings;
    FileGuard& m_guard;
    GuardQuestions& m_questions;
    QWidget* m_window;
};

class NoticeBar;
class RecentFilesMenu;

/// The commands for files: new, open, save and recover, with their dialogs.
class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Document& document, Settings& settings, QWidget* window);
    ~FileCommands() override;

    /// Locks and watches files from now on, and keeps recovery files and earlier versions in this
    /// folder. Without it only the saved file is written.
    void protect(const QString& stateFolder, Autosave::Times times = {});
    /// Sets the source of refused texts in fields, which no file contains.
    void askRefusedTexts(std::function<QStringList()> texts) { m_refused = std::move(texts); }
    /// Opens files of lessons, and is asked before a document is closed.
    struct Lessons {
        std::function<void(const QString& path)> open;
        std::function<bool()> mayLeave;
    };
    void leaveLessonsTo(Lessons lessons) { m_lessons = std::move(lessons); }
    void remember(const QString& path); ///< among the recent files
    /// Offers unsaved work that was left, then opens FILE; called at the start.
    void start(const QString& file);

    void startNew(Operation operation);
    void open();
    bool openFile(const QString& path);    ///< without asking about unsaved changes
    void openInstead(const QString& path); ///< asks first
    void openExample();
    void openEarlierVersion();
    void recoverWork();
    bool save();
    bool saveAs();
    /// Asks what to do with unsaved changes and refused texts; false if the user cancels.
    [[nodiscard]] bool mayDiscard();
    /// Asks before the window closes; discarded changes stay recoverable for a while.
    [[nodiscard]] bool mayClose();

    [[nodiscard]] FileGuard& guard() { return m_guard; }
    [[nodiscard]] NoticeBar& notices() { return *m_bar; }
    [[nodiscard]] RecentFilesMenu& recentFiles() { return *m_recent; }

signals:
    void saved();
    void begun(const std::string& path);          ///< a new project, whose first input is requested
    void packChosen(const QString& path);         ///< instead of a project
    void measurementsChosen(const QString& path); ///< a table instead of a project

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void openAttached(const QString& path);
    void take(LoadedProject loaded, const QString& path, GuardQuestions::Opening opening);
    bool recover(bool alsoDiscarded);
    bool openAsCopy(const QString& path);
    void reload();
    void showWhyRefused(const LoadedProject& loaded, const QString& path);

    Document& m_document;
    Settings& m_settings;
    QWidget* m_window;
    NoticeBar* m_bar;
    RecentFilesMenu* m_recent;
    Lessons m_lessons{[](const QString&) {}, [] { return true; }};
    std::function<QStringList()> m_refused = [] { return QStringList(); };
    DiskWait m_wait;
    FileGuard m_guard;
    GuardQuestions m_questions;
    FileNotices m_notices;
    ProjectSaver m_saver;
    WorkRecovery m_recovery;
};

} // namespace sparkout
