// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/lesson/answer_field.h"

#include <vector>

class QLabel;

namespace sparkout {

class CurveSketch;
class NumberField;

/// A curve predicted before the run, drawn by points or typed; later the engine's is drawn over it.
class CurveAnswer : public AnswerField {
    Q_OBJECT

public:
    CurveAnswer(CurvePrediction goal, const Project& project, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void showResult(const GoalResult& result) override;
    void retranslate() override;

private:
    void buildFields();
    void showSketch();

    CurvePrediction m_goal;
    Project m_project;
    CurveSketch* m_sketch;
    QLabel* m_note;
    QLabel* m_topLabel;
    NumberField* m_top;
    QWidget* m_topRow;
    QLabel* m_head;
    std::vector<QLabel*> m_places;
    std::vector<NumberField*> m_fields;
};

} // namespace sparkout
