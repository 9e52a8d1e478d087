// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/machine.h"
#include "core/project/project.h"
#include "core/simulation/result.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace sparkout {

/// Explains the steps E1…E5 in each zone, in the colours of the bands, and how to read the curves.
class FeedsNote : public QDialog {
    Q_OBJECT
public:
    explicit FeedsNote(QWidget* parent = nullptr);

    void setOperation(Operation operation, ReversalInfeed infeed);
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QLabel* cell(int row, int column);
    void paintSteps();
    /// Whether a zone is ground in the step: a reversal without infeed has no plunge-in.
    [[nodiscard]] bool isGround(Zone zone, Step step) const;

    Operation m_operation;
    ReversalInfeed m_infeed = ReversalInfeed::entry;
    QWidget* m_steps;
    QLabel* m_text;
    QPushButton* m_close;
};

} // namespace sparkout
