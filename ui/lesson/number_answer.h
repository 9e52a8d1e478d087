// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/lesson/answer_field.h"

class QLabel;

namespace sparkout {

class NumberField;

/// A number predicted before the run; later the engine's is shown below it.
class NumberAnswer : public AnswerField {
    Q_OBJECT

public:
    NumberAnswer(NumberPrediction goal, const Project& project, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void showResult(const GoalResult& result) override;
    void retranslate() override;

private:
    NumberPrediction m_goal;
    Project m_project;
    QLabel* m_label;
    NumberField* m_field;
    QLabel* m_unit;
    QLabel* m_resultLabel;
    QLabel* m_result;
    std::optional<double> m_value; ///< the engine's
};

} // namespace sparkout
