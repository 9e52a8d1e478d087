// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/number_answer.h"

#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_text.h"

#include <QGridLayout>
#include <QLabel>

#include <utility>

namespace sparkout {

namespace {

NumberSpec anyNumber(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.optional = true;
    return spec;
}

} // namespace

NumberAnswer::NumberAnswer(NumberPrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_label(new QLabel(this))
    , m_field(new NumberField(anyNumber(m_goal.figure), this))
    , m_unit(new QLabel(this))
    , m_resultLabel(new QLabel(this))
    , m_result(new QLabel(this)) {
    m_field->setObjectName(QStringLiteral("predictedNumber"));
    m_result->setObjectName(QStringLiteral("resultNumber"));
    setTextMinimumWidth(*m_field, metrics::field);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    for (QLabel* label : {m_label, m_resultLabel}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_label->setBuddy(m_field);
    grid->addWidget(m_label, 0, 0);
    grid->addWidget(m_field, 0, 1);
    grid->addWidget(m_unit, 0, 2);
    grid->addWidget(m_resultLabel, 1, 0);
    grid->addWidget(m_result, 1, 1, 1, 2);
    grid->setColumnStretch(0, 1);
    m_resultLabel->hide();
    m_result->hide();
    connect(m_field, &NumberField::valueEdited, this, &AnswerField::edited);
    NumberAnswer::retranslate();
}

void NumberAnswer::show(const Answer& answer) {
    m_field->reset(answer.number);
}

void NumberAnswer::put(Answer& answer) const {
    answer.number = m_field->value();
}

bool NumberAnswer::isWhole() const {
    return m_field->value().has_value() && !m_field->refused();
}

void NumberAnswer::lock() {
    m_field->setEnabled(false);
}

void NumberAnswer::showResult(const GoalResult& result) {
    m_value = result.value;
    m_resultLabel->setVisible(m_value.has_value());
    m_result->setVisible(m_value.has_value());
    retranslate();
}

void NumberAnswer::retranslate() {
    m_label->setText(m_goal.after_run ? tr("Your answer") : tr("Your prediction"));
    m_field->setAccessibleName(
        (m_goal.after_run ? tr("Your answer: %1") : tr("Your prediction: %1"))
            .arg(LessonText::figure(m_goal.figure, m_project)));
    m_field->retranslate();
    m_unit->setText(LessonText::unit(m_goal.figure));
    m_resultLabel->setText(tr("Result of the run"));
    m_result->setText(m_value ? LessonText::value(*m_value, m_goal.figure) : QString());
}

} // namespace sparkout
