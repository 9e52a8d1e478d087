// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/studies.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

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

} // namespace sparkout
