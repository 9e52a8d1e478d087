// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/lesson/answer_field.h"

class QLabel;
class QPlainTextEdit;

namespace sparkout {

/// An answer in words, which the teacher reads.
class TextAnswer : public AnswerField {
    Q_OBJECT

public:
    TextAnswer(TextGoal goal, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void retranslate() override;

private:
    [[nodiscard]] int letters() const;
    void showLetters();

    TextGoal m_goal;
    QPlainTextEdit* m_text;
    QLabel* m_letters;
};

} // namespace sparkout
