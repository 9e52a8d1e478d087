// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course/course_papers.h"
#include "ui/report/handout/course_handout.h"

#include <QDialog>

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;

namespace sparkout {

class CycleCursor;
class Settings;

/// Asks what a course hand-out is to have: with its results or without them, the step that it works
/// out, figures, the answers.
class HandoutDialog : public QDialog {
    Q_OBJECT

public:
    /// Steps are those of the outcome; first where the cycle stands.
    HandoutDialog(const OutcomePtr& outcome, const CycleCursor& cycle, Settings& settings,
                  QWidget* parent);

    [[nodiscard]] report::HandoutOptions options() const;
    /// The worksheet or its key; nothing: the hand-out itself.
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
