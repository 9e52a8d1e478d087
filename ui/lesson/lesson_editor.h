// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/file_questions.h"
#include "ui/lesson/lesson_draft.h"
#include "ui/session/guarded_file.h"

#include <QDialog>
#include <QTimer>

#include <optional>

class QListWidget;
class QMenu;
class QPushButton;
class QVBoxLayout;

namespace sparkout {

class Document;
class LessonPage;
class Settings;

/// The editor of laboratory works: the work and its steps on the left, the page of one of them
/// beside them, the faults found by the reader of lessons below. The project is exchanged with the
/// window, in which the work can be tried.
class LessonEditor : public QDialog {
    Q_OBJECT

public:
    LessonEditor(Document& document, Settings& settings, QWidget* window);

    /// Locks the lesson's file from now on, and keeps earlier versions in this folder.
    void protect(const QString& stateFolder) { m_file.protect(stateFolder); }
    [[nodiscard]] LessonDraft& draft() { return m_draft; }
    bool
    openLesson(const QString& path); ///< a file, or a shipped lesson as a new one; false if refused
    [[nodiscard]] bool isWhole();    ///< whether it has no faults; shows them
    [[nodiscard]] QMenu& papers() const { return *m_papers; } ///< papers made from the work
    /// Asks what to do with unsaved changes; false if the teacher cancels.
    [[nodiscard]] bool mayClose();
    void retranslate();

signals:
    /// A trial as a student, from a step on, was requested.
    void trialWanted(const sparkout::Lesson& lesson, std::size_t step);
    void projectWanted(); ///< show the project of the lesson in the window

protected:
    void reject() override;

private:
    enum Move { moveUp = -1, moveDown = 1 };

    void build();
    void beginAbout(); ///< the project in the window
    void chooseFile();
    void chooseShipped();
    bool save();
    bool saveAs();
    bool write(const QString& path);
    void reload();
    [[nodiscard]] std::optional<Lesson> readFrom(const QString& path, QByteArray& hash);
    void tryOut();
    void checkVariants();
    void takeProject();
    void showPage();
    void showState();
    void showFaults();
    void goTo(const std::string& path);
    void addStep(bool copies);
    void moveStep(Move by);
    void removeStep();
    [[nodiscard]] int step() const; ///< current, from 0; −1: the work as a whole
    [[nodiscard]] QString fileName() const;

    Document& m_document;
    Settings& m_settings;
    LessonDraft m_draft;
    GuardedFile m_file;
    DiskWait m_wait;
    GuardQuestions m_questions;
    QTimer m_check; ///< the faults, after a pause
    QListWidget* m_pages;
    QVBoxLayout* m_place; ///< place of the current page
    LessonPage* m_page = nullptr;
    int m_shown = -1; ///< step of the page
    QListWidget* m_faults;
    QMenu* m_papers;
    struct Button {
        QPushButton* button;
        QString (*text)();
        QString (*tip)();
    };
    std::vector<Button> m_buttons;
    QPushButton *m_undo = nullptr, *m_redo = nullptr;
    std::vector<QPushButton*> m_ofSteps; ///< actions on the current step
};

} // namespace sparkout
