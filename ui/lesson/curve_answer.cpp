// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/curve_answer.h"

#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/curve_sketch.h"
#include "ui/lesson/lesson_text.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr double usualTop = 10;
constexpr int typedField = 72, besideEachOther = 2;

NumberSpec valueSpec(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.optional = true;
    return spec;
}

NumberSpec topSpec(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.hard = {1e-6, 1e9};
    return spec;
}

} // namespace

CurveAnswer::CurveAnswer(CurvePrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_sketch(new CurveSketch(m_goal.at, this))
    , m_note(new QLabel(this))
    , m_topLabel(new QLabel(this))
    , m_top(new NumberField(topSpec(m_goal.figure), this))
    , m_topRow(new QWidget(this))
    , m_head(new QLabel(this)) {
    m_sketch->setObjectName(QStringLiteral("curveSketch"));
    m_note->setWordWrap(true);
    m_head->setWordWrap(true);
    m_top->setObjectName(QStringLiteral("curveTop"));
    m_top->setValue(usualTop);
    m_topLabel->setBuddy(m_top);
    setTextWidth(*m_top, typedField);
    auto* top = new QHBoxLayout(m_topRow);
    top->setContentsMargins(0, 0, 0, 0);
    top->addWidget(m_topLabel, 1);
    top->addWidget(m_top);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::gap);
    layout->addWidget(m_note);
    layout->addWidget(m_sketch);
    layout->addWidget(m_topRow);
    layout->addWidget(m_head);
    buildFields();
    connect(m_top, &NumberField::valueEdited, this,
            [this] { m_sketch->setTop(m_top->value().value_or(usualTop)); });
    connect(m_sketch, &CurveSketch::placed, this,
            [this](std::size_t place, std::optional<double> value) {
                m_fields[place]->reset(value);
                showSketch();
                emit edited();
            });
    CurveAnswer::retranslate();
}

void CurveAnswer::buildFields() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    const auto lines =
        (m_goal.at.size() + besideEachOther - 1) / besideEachOther; // from top to bottom
    for (std::size_t i = 0; i < m_goal.at.size(); ++i) {
        auto* label = new QLabel(this);
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto* field = new NumberField(valueSpec(m_goal.figure), this);
        field->setObjectName(QStringLiteral("curveValue%1").arg(i + 1));
        setTextWidth(*field, typedField);
        label->setBuddy(field);
        const int row = static_cast<int>(i % lines), column = static_cast<int>(i / lines) * 2;
        grid->addWidget(label, row, column);
        grid->addWidget(field, row, column + 1);
        connect(field, &NumberField::valueEdited, this, [this] {
            showSketch();
            emit edited();
        });
        m_places.push_back(label);
        m_fields.push_back(field);
    }
    grid->setColumnStretch(2 * besideEachOther, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

void CurveAnswer::showSketch() {
    CurveSketch::Values values;
    for (const NumberField* field : m_fields) {
        values.push_back(field->value());
    }
    m_sketch->setSaid(values);
}

void CurveAnswer::show(const Answer& answer) {
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        std::optional<double> value;
        for (const auto& row : answer.curve.value_or(std::vector<std::vector<double>>())) {
            if (row.size() == 2 && row[0] == m_goal.at[i]) {
                value = row[1];
            }
        }
        m_fields[i]->reset(value);
    }
    showSketch();
}

void CurveAnswer::put(Answer& answer) const {
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (const auto value = m_fields[i]->value()) {
            rows.push_back({m_goal.at[i], *value});
        }
    }
    answer.curve.reset();
    if (!rows.empty()) {
        answer.curve = std::move(rows);
    }
}

bool CurveAnswer::isWhole() const {
    return std::ranges::all_of(m_fields, [](const NumberField* field) {
        return field->value().has_value() && !field->refused();
    });
}

void CurveAnswer::lock() {
    m_sketch->setEditable(false);
    m_topRow->hide();
    for (NumberField* field : m_fields) {
        field->setEnabled(false);
    }
}

void CurveAnswer::showResult(const GoalResult& result) {
    CurveSketch::Values values;
    for (const ComparedPoint& point : result.curve) {
        values.emplace_back(point.value);
    }
    m_sketch->setFound(values);
    if (!values.empty()) {
        double most = 0;
        for (const auto& value : values) {
            most = std::max(most, value.value_or(0));
        }
        m_sketch->setTop(std::max(most, 1e-6)); // includes the prediction
    }
    retranslate();
}

void CurveAnswer::retranslate() {
    const QString figure = LessonText::figure(m_goal.figure, m_project);
    const QString unit = LessonText::unit(m_goal.figure);
    const QString value = unit.isEmpty() ? figure : tr("%1, %2").arg(figure, unit);
    const QString along = LessonText::along(m_goal, m_project);
    m_note->setText(tr("Click into the plot for each point, or type the values below it."));
    m_note->setVisible(!m_topRow->isHidden());
    m_topLabel->setText(unit.isEmpty() ? tr("The axis goes up to")
                                       : tr("The axis goes up to, %1").arg(unit));
    m_top->setAccessibleName(m_topLabel->text());
    m_top->retranslate();
    m_head->setText(tr("%1 and value").arg(along));
    QStringList places;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const QString place = LessonText::at(m_goal, m_goal.at[i], m_project);
        places += place;
        m_places[i]->setText(place);
        m_fields[i]->setAccessibleName(tr("%1 %2: %3").arg(along, place, value));
        m_fields[i]->retranslate();
    }
    m_sketch->setLabels(places, along, value);
    m_sketch->setCurveNames(tr("prediction"), tr("result"));
    m_sketch->setAccessibleName(tr("Your curve: %1").arg(value));
    m_sketch->setAccessibleDescription(
        tr("Left and Right choose a place, Up and Down move its point, Del takes it away."));
}

} // namespace sparkout
