// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/work.h"
#include "ui/dialogs/file_questions.h"
#include "ui/lesson/hidden_things.h"
#include "ui/session/guarded_file.h"
#include "ui/session/lesson_run.h"
#include "ui/session/setup_state.h"

#include <QObject>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

class QWidget;

namespace sparkout {

class Document;
class LessonPanel;
class MarksDialog;
class NoticeBar;
class Settings;

/// Laboratory works in the window: opens lessons and works of students, puts each step's set-up
/// into the document with a gate that allows only free inputs, and saves the work. A lesson ends
/// when another document is opened.
class LessonDesk : public QObject {
    Q_OBJECT

public:
    /// Seed of variants chosen by number, so that they are the same everywhere.
    static constexpr std::uint32_t seedByNumber = 1;

    LessonDesk(Document& document, Settings& settings, NoticeBar& notices, QWidget* window);
    ~LessonDesk() override;

    [[nodiscard]] LessonRun& run() { return m_run; }
    [[nodiscard]] const LessonRun& run() const { return m_run; }
    [[nodiscard]] LessonPanel& panel() { return *m_panel; }
    [[nodiscard]] HiddenThings& hidden() { return m_hidden; }
    [[nodiscard]] const HiddenThings& hidden() const { return m_hidden; }
    [[nodiscard]] bool isRunning() const { return m_run.isRunning(); }
    [[nodiscard]] bool isCovered() const { return m_run.isCovered(); }

    /// Locks and watches works from now on, and keeps earlier versions and drafts of them in this
    /// folder.
    void protect(const QString& stateFolder);
    [[nodiscard]] const QString& stateFolder() const { return m_stateFolder; }
    [[nodiscard]] bool isReadOnly() const { return isRunning() && m_file.isReadOnly(); }
    /// Sets a function that commits typed text, called first.
    void endTypingBy(std::function<void()> end) { m_endTyping = std::move(end); }

    [[nodiscard]] static bool isOfLesson(const QString& path); ///< by its suffix
    void open(const QString& path); ///< a lesson or a work; shows its faults
    /// Opens a lesson chosen from a list; `mayDiscard` asks whether the current document may be
    /// closed.
    void choose(const std::function<bool()>& mayDiscard);
    /// Tries a lesson as a student would, from a step on, without keeping anything. False if it was
    /// not begun.
    bool tryOut(const Lesson& lesson, std::size_t step);
    void markWorks(); ///< shows the window for marking
    void save();
    void saveAs();
    void leave(); ///< to a new project
    void showStep(std::size_t step);
    void showNext(int by);
    /// Before the window closes or another document is opened: saves everything, or the user
    /// discards it.
    [[nodiscard]] bool mayLeave();
    /// Called when the views show a run of the current inputs.
    void takeOutcome(bool ran);
    void takeKeptRun(const KeptRun& run) { m_run.keepRun(run); }
    void retranslate();

signals:
    void limitsChanged(); ///< another step, or none: changes what is free, hidden and covered
    void uncovered();     ///< the result may be shown
    void momentWanted(const sparkout::ShownMoment& moment);
    void opened(const QString& path); ///< a work
    void tried();                     ///< a trial has ended
    void reported(const QString& text);

private:
    void openLesson(const QString& path);
    void openWork(const QString& path);
    void begin(const Lesson& lesson, const QString& name);
    void start(Work work, const QString& path, bool isSaved);
    [[nodiscard]] QString askPath(const QString& suggested);
    /// Asks about every obstacle and writes a work; the path may change, or become empty.
    [[nodiscard]] GuardQuestions::Outcome keep(const Work& work, QString& path);
    bool write(QString path); ///< the work that is being done
    void showNotSaved();
    void showFileState();
    void showChangedOnDisk();
    [[nodiscard]] QString draftFolder() const;
    [[nodiscard]] std::optional<std::string> textOf(const QString& path);
    [[nodiscard]] std::optional<Work> makeWork(const Lesson& lesson, int variant,
                                               const QString& name, const QString& group);
    void showFaults(const QString& path, const Issues& issues);
    void putStep();
    void handIn(Answer answer);
    void takeEntry();
    void keepDraft();
    [[nodiscard]] bool allows(const SetupState& after) const;
    void endRun(); ///< its file is still followed
    void finish();

    Document& m_document;
    Settings& m_settings;
    NoticeBar& m_notices;
    QWidget* m_window;
    LessonRun m_run;
    LessonPanel* m_panel;
    MarksDialog* m_marks = nullptr; ///< created on request
    HiddenThings m_hidden;
    std::function<void()> m_endTyping = [] {};
    std::optional<ShownMoment> m_moment; ///< shown with the next outcome
    GuardedFile m_file;                  ///< the file of the work
    DiskWait m_wait;
    GuardQuestions m_questions;
    bool m_wasCovered = false; ///< before handing in
    QTimer m_draft;
    /// A trial of a lesson, and the work that it interrupts.
    struct Trial {
        QTemporaryDir folder;
        Setup base;
    };
    std::unique_ptr<Trial> m_trial;
    QString m_stateFolder;
    bool m_isOwn = false; ///< a step is replacing the document
};

} // namespace sparkout
