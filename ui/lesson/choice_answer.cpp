// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/choice_answer.h"

#include "ui/kit/markup_text.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// The text of an option; clicking it clicks its box.
class OptionText : public MarkupText {
public:
    OptionText(QCheckBox& box, QWidget* parent) : MarkupText(parent), m_box(box) {
        setTextInteractionFlags(Qt::NoTextInteraction);
    }

protected:
    void mouseReleaseEvent(QMouseEvent* event) override {
        if (m_box.isEnabled() && rect().contains(event->position().toPoint())) {
            m_box.click();
        }
    }

private:
    QCheckBox& m_box;
};

} // namespace

ChoiceAnswer::ChoiceAnswer(ChoiceGoal goal, QWidget* parent)
    : AnswerField(parent), m_goal(std::move(goal)), m_note(new QLabel(this)) {
    m_note->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::gap);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_note, 0, 0, 1, 2);
    for (std::size_t i = 0; i < m_goal.options.size(); ++i) {
        auto* box = new QCheckBox(this);
        box->setObjectName(QStringLiteral("option%1").arg(i + 1));
        auto* text = new OptionText(*box, this);
        const int row = static_cast<int>(i) + 1;
        grid->addWidget(box, row, 0, Qt::AlignTop);
        grid->addWidget(text, row, 1);
        connect(box, &QCheckBox::clicked, this, &AnswerField::edited);
        m_boxes.push_back(box);
        m_texts.push_back(text);
    }
    ChoiceAnswer::retranslate();
}

void ChoiceAnswer::show(const Answer& answer) {
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->setChecked(answer.chosen
                               && std::ranges::find(*answer.chosen, static_cast<double>(i + 1))
                                      != answer.chosen->end());
    }
}

void ChoiceAnswer::put(Answer& answer) const {
    std::vector<double> chosen;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        if (m_boxes[i]->isChecked()) {
            chosen.push_back(static_cast<double>(i + 1));
        }
    }
    answer.chosen.reset();
    if (!chosen.empty()) {
        answer.chosen = std::move(chosen);
    }
}

bool ChoiceAnswer::isWhole() const {
    return std::ranges::any_of(m_boxes, &QCheckBox::isChecked);
}

void ChoiceAnswer::lock() {
    for (QCheckBox* box : m_boxes) {
        box->setEnabled(false);
    }
}

void ChoiceAnswer::retranslate() {
    m_note->setText(tr("Tick every correct answer; there may be more than one."));
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_texts[i]->setMarkup(LessonText::tagged(m_goal.options[i].text));
        m_boxes[i]->setAccessibleName(m_texts[i]->toPlainText());
    }
}

} // namespace sparkout
