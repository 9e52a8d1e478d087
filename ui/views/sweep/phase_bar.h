// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/session/job.h"
#include "ui/views/sweep/phase_chart.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace sparkout {

class NumberField;
class RunBar;

/// Checks all stocks of a project by itself after a change of it or of the range: the two ends of
/// the range, buttons to stop and to run again, and a text on the result.
class PhaseBar : public QWidget {
    Q_OBJECT
public:
    explicit PhaseBar(QWidget* parent = nullptr);

    void follow(const Project& project); ///< starts the check, unless it is done or running
    void forget(); ///< forgets project, range and result before another document
    /// The last result; null if there is none, or if the project cannot be checked.
    [[nodiscard]] const PhaseOutcomePtr& phases() const { return m_phases; }
    [[nodiscard]] bool busy() const { return m_job->running(); }
    [[nodiscard]] bool stale() const { return m_stale; } ///< another project or range
    [[nodiscard]] QString remark() const;                ///< the result, or why there is none
    void showState(bool accepted);                       ///< false: the newest inputs are refused
    void retranslate();

signals:
    void changed(); ///< the result, or whether it is being computed

private:
    [[nodiscard]] StockRange range() const;
    [[nodiscard]] bool canRun() const;
    void addEnd(NumberField& field, std::optional<double> PhaseBar::*own, double StockRange::*end);
    void showRange();
    void noteStale();
    void decide(); ///< starts the check if needed
    void run();
    void take(const PhaseOutcomePtr& phases);

    std::optional<Project> m_project;
    std::optional<double> m_ownFrom_mm, m_ownTo_mm; ///< typed by the user
    PhaseOutcomePtr m_phases;
    bool m_stale = true;
    std::optional<PhaseOutcome> m_running; ///< the running check, without its result
    Job* m_job;
    NumberField *m_from, *m_to;
    QLabel *m_dash, *m_unit;
    RunBar* m_bar;
};

} // namespace sparkout
