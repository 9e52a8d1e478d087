// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_data.h"
#include "core/measured/trial_design.h"
#include "core/project/project.h"
#include "ui/session/job.h"

#include <QWidget>

#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

using TrialDesignPtr = std::shared_ptr<const TrialDesign>;

class FitTable;

/// The most informative short trials for the parameters of interest: trials with several feeds,
/// without and with a spark-out, by recorded quantity, the best first.
class TrialPage : public QWidget {
    Q_OBJECT

public:
    explicit TrialPage(const Project& project, QWidget* parent = nullptr);

private:
    QWidget* buildChoices();
    QWidget* buildButtons();
    void follow();
    void start();
    void showDesign();
    void showTrial(int row); ///< the steps at the machine
    [[nodiscard]] std::vector<FittedParameter> parameters() const;
    [[nodiscard]] QStringList cellsOf(const Trial& trial) const;
    [[nodiscard]] QString stepsOf(const Trial& trial) const;

    const Project& m_project;
    std::vector<std::pair<FittedKind, QCheckBox*>> m_kinds;
    QComboBox* m_record;
    FitTable* m_table;
    QLabel* m_words;
    QLabel* m_fault;
    QProgressBar* m_progress;
    QPushButton *m_find, *m_stop;
    TrialRequest m_requested;
    TrialDesignPtr m_design;
    std::vector<const Trial*> m_shown; ///< row by row
    Job m_job; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
