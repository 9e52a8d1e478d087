// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTabWidget;
class QTextBrowser;
class QToolButton;
class QVBoxLayout;

namespace sparkout {

class AnswerField;
class LessonRun;
class MarkupText;

/// A laboratory work for its student: aim and theory, the steps with their states, the task, the
/// answer, the result, and hints, each for its price.
class LessonPanel : public QWidget {
    Q_OBJECT

public:
    explicit LessonPanel(LessonRun& run, QWidget* parent = nullptr);

    void retranslate();
    /// The current contents, without a set-up.
    [[nodiscard]] Answer answer() const;
    [[nodiscard]] AnswerField* field() const { return m_field; } ///< null: answered by settings

signals:
    void handInAsked(const sparkout::Answer& answer);
    void stepAsked(std::size_t step);
    void edited(); ///< the contents have changed

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void buildHead(QVBoxLayout& into);
    void buildTask();
    void showStep(); ///< the current step has changed
    void showState();
    void showSteps();
    void showAnswered();
    void showHints();
    void goTo(int by);

    LessonRun& m_run;
    QLabel* m_title;
    QLabel* m_who;
    QLabel* m_points;
    QToolButton* m_previous;
    QComboBox* m_steps;
    QToolButton* m_next;
    QTabWidget* m_tabs;
    QTextBrowser* m_theory;
    QWidget* m_taskPage;
    MarkupText* m_task;
    QLabel* m_asked;
    AnswerField* m_field = nullptr;
    QVBoxLayout* m_place = nullptr; ///< place of the field
    QLabel* m_note;
    QPushButton* m_handIn;
    QLabel* m_found;
    QLabel* m_attempts;
    QVBoxLayout* m_hints = nullptr;
    QPushButton* m_takeHint;
};

} // namespace sparkout
