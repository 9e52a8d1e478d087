// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/grading.h"
#include "core/lesson/lesson.h"
#include "ui/session/job.h"

#include <QDialog>
#include <QStringList>

#include <optional>
#include <stop_token>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTextBrowser;

namespace sparkout {

class CopyTable;
class Settings;
class ValueModel;

/// Marks works against their lesson in a non-modal window, like `sparkout-cli course grade`. Files
/// and folders are chosen by buttons or dropped: lessons, works, the list of students and the
/// teacher's table of best answers are recognised by their contents.
class MarksDialog : public QDialog {
    Q_OBJECT

public:
    MarksDialog(Settings& settings, QWidget* parent);
    ~MarksDialog() override;

    void add(const QStringList& paths);
    void mark();
    [[nodiscard]] const std::vector<GradedWork>& marks() const { return m_marks; }
    [[nodiscard]] const Lesson& lesson() const { return m_marked; } ///< the lesson of the marks
    [[nodiscard]] bool busy() const { return m_isBusy; }

signals:
    void marked();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    void addFile(const QString& path, QStringList& faults);
    void addLesson();
    void addWorks(bool wholeFolder);
    void addList();
    void showInputs();
    void showWork();
    void setBusy(bool busy);
    void take(std::vector<GradedWork> works);
    void exportCsv();
    [[nodiscard]] QString detail(const GradedWork& work) const;

    Settings& m_settings;
    std::optional<Lesson> m_lesson;
    QString m_lessonName;
    QStringList m_works; ///< paths
    GradeWish m_wish;
    bool m_isBusy = false;
    std::vector<GradedWork> m_marks;
    Lesson m_marked; ///< their lesson
    ValueModel* m_model;
    QLabel* m_inputs;
    QPushButton* m_mark = nullptr;
    QPushButton *m_export = nullptr, *m_book = nullptr; ///< buttons for CSV and for a workbook
    QPushButton* m_stop = nullptr;
    QProgressBar* m_progress;
    CopyTable* m_table;
    QTextBrowser* m_detail;
    std::stop_source m_marking; ///< to stop by the user
    NewestJob m_job;            ///< last member: stopped before the objects it uses are destroyed
};

} // namespace sparkout
