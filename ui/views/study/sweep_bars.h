// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/number_input.h"
#include "core/project/project.h"
#include "core/project/sweep.h"
#include "ui/session/job.h"
#include "ui/views/study/phase_chart.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QSpinBox;

namespace sparkout {

class NumberField;
class RunBar;
class SearchCombo;

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

/// One varied input: its choice, its range and the number of points.
class SweepAxisBox : public QWidget {
    Q_OBJECT
public:
    /// @param place 0 or 1, the index of the varied input
    explicit SweepAxisBox(std::size_t place, QWidget* parent = nullptr);

    /// Shows the sweep of a project and the inputs that it could vary.
    void show(const Project& project);
    void retranslate();

signals:
    void inputChosen(const std::string& path); ///< empty: none
    void axisEdited(const sparkout::SweepAxis& axis);

private:
    static QString wordsOf(const NumberInput& input); ///< words by which it is found
    void fillInputs(const std::vector<NumberInput>& inputs);
    void showAxis(const std::optional<NumberInput>& input);
    void onInput();
    void onRange();

    std::size_t m_place;
    SearchCombo* m_input;
    NumberField *m_from, *m_to;
    QLabel *m_dash, *m_unit;
    QSpinBox* m_points;
    QCheckBox* m_ratios;
    std::vector<std::string> m_paths; ///< paths of the entries after the first
    std::optional<SweepAxis> m_axis;
    std::optional<NumberInput> m_of; ///< the varied input
};

} // namespace sparkout
