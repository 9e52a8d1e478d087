// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course_handout.h"
#include "ui/report/course_papers.h"

#include <QDialog>

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;

namespace sparkout {

class CycleCursor;
class Settings;

/// Asks for the contents of a course hand-out: with or without results, the step to work out,
/// figures, the answers.
class HandoutDialog : public QDialog {
    Q_OBJECT

public:
    /// Offers steps of the outcome, first that at the cycle's moment.
    HandoutDialog(const OutcomePtr& outcome, const CycleCursor& cycle, Settings& settings,
                  QWidget* parent);

    [[nodiscard]] report::HandoutOptions options() const;
    /// The worksheet or its key; empty: the hand-out itself.
    [[nodiscard]] std::optional<report::Paper> paper() const;

    void accept() override; ///< figures and answers are chosen alike the next time

private:
    void offerSteps(const OutcomePtr& outcome, const CycleCursor& cycle);
    void recall();

    Settings& m_settings;
    QComboBox* m_form;
    QComboBox* m_step;
    std::vector<report::StepWish> m_wishes; ///< by index of the list
    std::vector<QCheckBox*> m_views;        ///< in the order of report::handoutViews()
    QCheckBox* m_answers;
};

} // namespace sparkout
