// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course_papers.h"
#include "ui/report/report_kinds.h"
#include "ui/session/studies.h"
#include "ui/window/dialogs/export_dialog.h"

#include <QDialog>
#include <QObject>

#include <functional>
#include <optional>

class QWidget;

class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

class Settings;

/// The command that exports a result with its trace to a file.
class ExportCommands : public QObject {
    Q_OBJECT

public:
    /// `outcome` returns the one of the current inputs, `studies` the results of the views.
    ExportCommands(std::function<OutcomePtr()> outcome,
                   std::function<std::vector<StudyOffer>()> studies, Settings& settings,
                   QWidget* window);

    void exportResults();

private:
    std::function<OutcomePtr()> m_outcome;
    std::function<std::vector<StudyOffer>()> m_studies;
    Settings& m_settings;
    QWidget* m_window;
    ExportFormat m_format = ExportFormat::xlsx; ///< the last one chosen
};

/// Runs a batch that the caller waits for, with its progress and a way to stop.
class BatchWait : public QDialog {
    Q_OBJECT

public:
    BatchWait(const Project& project, const QString& what, QWidget* parent);

    /// The whole batch; with issues if it cannot be run; null after a stop.
    [[nodiscard]] BatchOutcomePtr wait();

private:
    void showProgress(qint64 done, qint64 parts, double left_s);

    Project m_project;
    QLabel* m_text;
    QProgressBar* m_progress;
    QPushButton* m_stop;
    BatchOutcomePtr m_outcome;
    Job m_job; ///< last member: stopped before the objects it reports to are destroyed
};

class CycleCursor;

/// Makes the reports on the contents of the window.
class ReportCommands : public QObject {
    Q_OBJECT

public:
    /// The subject of a report: an outcome, the path of its project, and the batch in the window,
    /// if any, possibly of other inputs.
    struct Subject {
        OutcomePtr outcome;
        QString file;
        BatchOutcomePtr batch;
        const CycleCursor* cycle = nullptr; ///< moment of the window's cycle
        std::optional<Setup> setup;         ///< for several surfaces, or wear
        std::size_t surface = 0;            ///< that of the outcome, in the set-up
        BatchOutcomePtr predicting = {};    ///< compared with measured parts; may be null
    };

    ReportCommands(std::function<Subject()> subject, Settings& settings, QWidget* window);

    /// The current report; empty if there is no result, which is shown, or its batch was stopped.
    [[nodiscard]] std::optional<report::Report> reportOfNow(report::Kind kind);

private:
    /// Uses the shown batch, or runs one; false without a batch, of which the user is informed. An
    /// optional batch may be refused.
    [[nodiscard]] bool addBatch(report::Subject& subject, const BatchOutcomePtr& shown,
                                bool isNeeded);

    /// Adds the batch to be compared with measured parts; true if there are none.
    [[nodiscard]] bool addPrediction(report::Subject& subject, const BatchOutcomePtr& shown);

    /// Runs all surfaces of the set-up; false, after informing the user, if it cannot be run.
    [[nodiscard]] bool addSetup(report::Subject& subject, const Setup& setup);

    /// Asks for the contents of the hand-out, or for a worksheet; false if cancelled.
    [[nodiscard]] bool chooseHandout(report::Subject& subject, const CycleCursor& cycle,
                                     std::optional<report::Paper>& paper);

    std::function<Subject()> m_subject;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
