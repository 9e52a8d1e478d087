// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/session/job.h"
#include "ui/views/sweep/phase_outcome.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace sparkout {

class NumberField;
class RunBar;

/// Decides the phases of the stock of a project by itself whenever it or the range changes: the
/// two ends of the range, buttons to stop and to run again, what was decided.
class PhaseBar : public QWidget {
    Q_OBJECT
public:
    explicit PhaseBar(QWidget* parent = nullptr);

    void follow(const Project& project); ///< decides it, unless that is done or being done
    void forget();                       ///< another document comes: project, range and phases
    /// The last that were decided; null: none, or of a project whose phases cannot be.
    [[nodiscard]] const PhaseOutcomePtr& phases() const { return m_phases; }
    [[nodiscard]] bool busy() const { return m_job->running(); }
    [[nodiscard]] bool stale() const { return m_stale; } ///< those are of another project or range
    [[nodiscard]] QString remark() const; ///< what was decided, or why nothing can be
    void showState(bool accepted);        ///< false: the newest inputs are refused
    void retranslate();

signals:
    void changed(); ///< what is known, or whether it is being decided

private:
    [[nodiscard]] StockRange range() const;
    [[nodiscard]] bool canRun() const;
    void addEnd(NumberField& field, std::optional<double> PhaseBar::*own, double StockRange::*end);
    void showRange();
    void noteStale();
    void decide(); ///< where need be
    void run();
    void take(const PhaseOutcomePtr& phases);

    std::optional<Project> m_project;
    std::optional<double> m_ownFrom_mm, m_ownTo_mm; ///< typed by the user
    PhaseOutcomePtr m_phases;
    bool m_stale = true;
    std::optional<PhaseOutcome> m_running; ///< what is being decided, without its decision
    Job* m_job;
    NumberField *m_from, *m_to;
    QLabel *m_dash, *m_unit;
    RunBar* m_bar;
};

} // namespace sparkout
