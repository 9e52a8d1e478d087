// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "core/lesson/work.h"
#include "ui/session/background.h"
#include "ui/session/job.h"

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace sparkout {

/// A laboratory work in progress: the answers handed in, their results by the engine, and the
/// current step. Every entry is sealed, and saveWanted() requests that the student's file be
/// written. Answers and settings not handed in yet are kept in a draft of the program's own, from
/// which the work can be continued.
class LessonRun : public QObject {
    Q_OBJECT

public:
    /// State of a step.
    enum class Mark {
        open,    ///< no answer was handed in
        checked, ///< handed in and being checked by the engine
        passed,
        failed,
        teacher ///< handed in, to be marked by the teacher
    };

    explicit LessonRun(QObject* parent = nullptr);
    ~LessonRun() override;

    /// Sets the folder for drafts; without it none is kept.
    void keepDraftsIn(const QString& folder) { m_draftFolder = folder; }

    [[nodiscard]] bool isRunning() const { return m_work.has_value(); }
    [[nodiscard]] const Work& work() const { return *m_work; }
    [[nodiscard]] const Lesson& lesson() const { return m_work->lesson; }
    [[nodiscard]] const QString& file() const { return m_file; }
    [[nodiscard]] std::size_t step() const { return m_step; }
    [[nodiscard]] const LessonStep& current() const { return lesson().steps[m_step]; }
    /// Returns the project of a step's surface at its beginning.
    [[nodiscard]] Project projectOf(std::size_t step) const;

    /// Begins or continues a work; `isSaved`: its file contains it.
    void start(Work work, const QString& file, bool isSaved);
    void end();                  ///< ends the work and keeps the draft
    void show(std::size_t step); ///< announce() follows once its set-up is in the document
    void announce() { emit stepShown(); }

    /// Returns whether the current step asks for a prediction that is not given yet; until then no
    /// result may be shown.
    [[nodiscard]] bool isCovered() const;
    /// Returns the other steps that ask for a prediction of the current set-up and have none yet:
    /// their answers must not be visible in this step.
    [[nodiscard]] std::vector<std::size_t> openPredictions() const;
    [[nodiscard]] StepRecord record(std::size_t step) const;
    /// Returns the engine's result for the answer that counts; null: not known yet.
    [[nodiscard]] const GoalResult* result(std::size_t step) const;
    [[nodiscard]] Mark mark(std::size_t step) const;
    [[nodiscard]] double
    pointsOf(std::size_t step) const; ///< points less those for the hints taken
    [[nodiscard]] double points() const;
    [[nodiscard]] bool isFull() const; ///< the work takes no further entry

    void handIn(Answer answer); ///< hands in an answer to the current step
    void takeHint();            ///< takes the next hint of the current step
    void keepRun(const KeptRun& run);

    /// Sets the contents of the panel and the inputs of the current step that are not handed in.
    void setDraft(Answer draft);
    /// Returns the answer shown in a step: the draft, or else the answer handed in last; null:
    /// neither.
    [[nodiscard]] const Answer* draft(std::size_t step) const;
    /// Returns the set-up shown in a step.
    [[nodiscard]] Setup setupFor(std::size_t step) const;

    /// Records that a file, which may be another one, contains the work with its first `entries`
    /// entries.
    void markSaved(const QString& file, std::size_t entries);
    /// Records that the file no longer contains the work, because another program changed or
    /// removed it.
    void markUnsaved() { m_savedEntries.reset(); }
    void flush(); ///< waits until the draft is written
    [[nodiscard]] bool isSaved() const { return m_savedEntries == m_work->entries.size(); }

signals:
    void started();
    void ended();
    void stepShown();
    void changed();    ///< an entry or a result was added
    void answered();   ///< the current step was answered
    void saveWanted(); ///< an entry was added; emitted last

private:
    void add(WorkEntry entry);
    [[nodiscard]] Setup settingsFor(std::size_t step) const;
    void check();
    void writeDraft();
    void readDraft();
    [[nodiscard]] QString draftFile() const;

    std::optional<Work> m_work;
    QString m_file;
    QString m_draftFolder;
    std::size_t m_step = 0;
    std::map<std::size_t, Answer> m_drafts;
    std::map<std::size_t, GoalResult> m_results; ///< results of the answers that count
    std::optional<std::size_t> m_savedEntries;   ///< empty: there is no file yet
    Background m_disk;
    NewestJob m_job; ///< last: stopped before the members that it uses are destroyed
};

} // namespace sparkout
