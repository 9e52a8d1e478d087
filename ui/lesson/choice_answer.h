// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/lesson/answer_field.h"

#include <vector>

class QCheckBox;
class QLabel;

namespace sparkout {

class MarkupText;

/// A choice of one or several options.
class ChoiceAnswer : public AnswerField {
    Q_OBJECT

public:
    ChoiceAnswer(ChoiceGoal goal, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void retranslate() override;

private:
    ChoiceGoal m_goal;
    QLabel* m_note;
    std::vector<QCheckBox*> m_boxes;
    std::vector<MarkupText*> m_texts;
};

} // namespace sparkout
