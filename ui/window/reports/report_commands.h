// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course/course_papers.h"
#include "ui/report/documents/report_kinds.h"

#include <QObject>

#include <functional>
#include <optional>

class QWidget;

namespace sparkout {

class CycleCursor;
class Settings;

/// Makes the reports of what is in the window.
class ReportCommands : public QObject {
    Q_OBJECT

public:
    /// What is to be reported: an outcome, the path of its project, and the batch that the window
    /// shows, if any: it may be of other inputs.
    struct Subject {
        OutcomePtr outcome;
        QString file;
        BatchOutcomePtr batch;
        const CycleCursor* cycle = nullptr; ///< where the window's cycle stands
        std::optional<Setup> setup;         ///< where there are several surfaces, or wear
        std::size_t surface = 0;            ///< that of the outcome, in the set-up
        BatchOutcomePtr predicting = {};    ///< that measured parts are held against; or null
    };

    ReportCommands(std::function<Subject()> subject, Settings& settings, QWidget* window);

    /// The report of now; nothing when there is no result, which is said, or its batch was stopped.
    [[nodiscard]] std::optional<report::Report> reportOfNow(report::Kind kind);

private:
    /// Takes the batch that is shown, or runs one; false: none, and the user knows.
    /// False: there is no report. One that is not needed may be refused.
    [[nodiscard]] bool addBatch(report::Subject& subject, const BatchOutcomePtr& shown,
                                bool isNeeded);

    /// The same of the batch that measured parts are held against; true where none are measured.
    [[nodiscard]] bool addPrediction(report::Subject& subject, const BatchOutcomePtr& shown);

    /// Runs all surfaces of the set-up; false: it cannot be run, and the user knows.
    [[nodiscard]] bool addSetup(report::Subject& subject, const Setup& setup);

    /// Asks what the hand-out is to have, or whether a worksheet is wanted; false: not to make one.
    [[nodiscard]] bool chooseHandout(report::Subject& subject, const CycleCursor& cycle,
                                     std::optional<report::Paper>& paper);

    std::function<Subject()> m_subject;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
