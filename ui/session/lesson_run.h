// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"
#include "core/lesson/goal_check.h"
#include "ui/session/background.h"
#include "ui/session/newest_job.h"

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace sparkout {

/// A laboratory work that is being done: what was handed in, what the engine finds of it, and the
/// step in front. Every entry is sealed, and saveWanted() asks for the student's file to be
/// written. What is not handed in yet, answers and settings, is kept in a draft of the program's
/// own, from which the work goes on where it was left.
class LessonRun : public QObject {
    Q_OBJECT

public:
    /// How a step stands.
    enum class Mark {
        open,    ///< nothing was handed in
        checked, ///< handed in, and the engine is at it
        passed,
        failed,
        teacher ///< handed in, for the teacher to mark
    };

    explicit LessonRun(QObject* parent = nullptr);
    ~LessonRun() override;

    /// Drafts are kept in this folder; without it none is.
    void keepDraftsIn(const QString& folder) { m_draftFolder = folder; }

    [[nodiscard]] bool isRunning() const { return m_work.has_value(); }
    [[nodiscard]] const Work& work() const { return *m_work; }
    [[nodiscard]] const Lesson& lesson() const { return m_work->lesson; }
    [[nodiscard]] const QString& file() const { return m_file; }
    [[nodiscard]] std::size_t step() const { return m_step; }
    [[nodiscard]] const LessonStep& current() const { return lesson().steps[m_step]; }
    /// The project of the surface that a step is about, as the step begins.
    [[nodiscard]] Project projectOf(std::size_t step) const;

    /// Begins or takes up a work; `isSaved`: its file holds it.
    void start(Work work, const QString& file, bool isSaved);
    void end();                  ///< keeps the draft
    void show(std::size_t step); ///< announce() follows once its set-up is in the document
    void announce() { emit stepShown(); }

    /// Whether a prediction is asked for in the step in front, and not given yet: till then nobody
    /// is to see a result.
    [[nodiscard]] bool isCovered() const;
    /// Other steps that ask for a prediction of the set-up in front and have none yet: what they
    /// ask is not to be read off in this one.
    [[nodiscard]] std::vector<std::size_t> openPredictions() const;
    [[nodiscard]] StepRecord record(std::size_t step) const;
    /// What the engine finds of the answer that counts; nothing while it is not known.
    [[nodiscard]] const GoalResult* result(std::size_t step) const;
    [[nodiscard]] Mark mark(std::size_t step) const;
    [[nodiscard]] double pointsOf(std::size_t step) const; ///< less the hints that were taken
    [[nodiscard]] double points() const;
    [[nodiscard]] bool isFull() const; ///< it takes no further entry

    void handIn(Answer answer); ///< as the answer to the step in front
    void takeHint();            ///< the next one of the step in front
    void keepRun(const KeptRun& run);

    /// What stands in the panel and the inputs of the step in front and is not handed in.
    void setDraft(Answer draft);
    /// What a step is shown with: the draft, else what was handed in last; null: neither.
    [[nodiscard]] const Answer* draft(std::size_t step) const;
    /// The set-up that a step is shown with.
    [[nodiscard]] Setup setupFor(std::size_t step) const;

    /// A file, which may be another one, holds the work with its first entries.
    void markSaved(const QString& file, std::size_t entries);
    /// The file no longer holds the work: another program has changed or removed it.
    void markUnsaved() { m_savedEntries.reset(); }
    void flush(); ///< until the draft is written
    [[nodiscard]] bool isSaved() const { return m_savedEntries == m_work->entries.size(); }

signals:
    void started();
    void ended();
    void stepShown();
    void changed();    ///< an entry came, or a result
    void answered();   ///< to the step in front
    void saveWanted(); ///< an entry came; last

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
    std::map<std::size_t, GoalResult> m_results; ///< of the answers that count
    std::optional<std::size_t> m_savedEntries;   ///< nothing: it has no file yet
    Background m_disk;
    NewestJob m_job; ///< last: stopped before what it uses is gone
};

} // namespace sparkout
