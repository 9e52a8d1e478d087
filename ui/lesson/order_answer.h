// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/lesson/answer_field.h"

class QLabel;
class QListWidget;
class QToolButton;

namespace sparkout {

/// The order of the zones or sections, the largest first, arranged by dragging, by buttons or by
/// Ctrl+Up and Ctrl+Down; later the engine's order is shown beside it.
class OrderAnswer : public AnswerField {
    Q_OBJECT

public:
    OrderAnswer(OrderPrediction goal, const Project& project, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void showResult(const GoalResult& result) override;
    void retranslate() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void move(int by);
    void fill(const std::vector<std::size_t>& order);
    void fitHeight();

    OrderPrediction m_goal;
    Project m_project;
    QLabel* m_note;
    QListWidget* m_list;
    QToolButton* m_up;
    QToolButton* m_down;
    QLabel* m_resultLabel;
    QListWidget* m_result;
    std::vector<std::size_t> m_found; ///< the engine's order
};

} // namespace sparkout
