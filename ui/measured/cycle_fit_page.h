// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/identification.h"
#include "core/project/project.h"
#include "ui/session/job.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

using IdentificationPtr = std::shared_ptr<const Identification>;

class DataChoice;
class FitResult;
class ParameterChoice;

/// Fits parameters of the process to measured cycles and parts, in the background, and offers the
/// result.
class CycleFitPage : public QWidget {
    Q_OBJECT

public:
    explicit CycleFitPage(const Project& project, QWidget* parent = nullptr);

signals:
    /// The project with the values found.
    void taken(const sparkout::Project& project);

private:
    QWidget* buildChoices();
    QWidget* buildButtons();
    void propose();
    void follow();
    void start();
    void showResult(const IdentificationPtr& result);
    void leaveOut();
    void fitTimes();
    void take();
    [[nodiscard]] Project calibrated() const; ///< the project with the fitted values
    /// Inputs that would be refused or unusual with the values found, in words.
    [[nodiscard]] QString consequences() const;
    [[nodiscard]] IdentificationRequest request() const;

    const Project& m_project;
    DataChoice* m_data;
    ParameterChoice* m_parameters;
    QComboBox* m_loss;
    QLabel* m_fault;
    FitResult* m_shown;
    QProgressBar* m_progress;
    QPushButton* m_fit;
    QPushButton* m_stop;
    QPushButton* m_leaveOut;
    QPushButton* m_fitTimes;
    QPushButton* m_take;
    IdentificationRequest m_requested;
    IdentificationPtr m_result;
    Job m_job; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
