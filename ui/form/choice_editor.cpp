// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/choice_editor.h"

#include "ui/kit/search_combo.h"
#include "ui/text/texts.h"

#include <QWheelEvent>

#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t fewChoices = 12; ///< without a search

} // namespace

void StillComboBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

ChoiceEditor::Choosing ChoiceEditor::choicesOf(const Field& field) {
    return {
        [&field] {
            std::vector<Option> options;
            for (const Choice& choice : field.choices) {
                options.push_back({choiceText(choice.label), static_cast<int>(options.size())});
            }
            return options;
        },
        [&field](const void* owner) { return field.getChoice(owner); },
        [&field](void* owner, const QVariant& chosen) { field.setChoice(owner, chosen.toInt()); }};
}

ChoiceEditor::ChoiceEditor(const std::string& path, const Field& field, FormModel& model,
                           QWidget* parent, Choosing by)
    : FieldEditor(path, field, model)
    , m_by(std::move(by))
    , m_box(m_by.options().size() > fewChoices ? new SearchCombo(parent) : new QComboBox(parent)) {
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_box->installEventFilter(this);
    connect(m_box, &QComboBox::activated, this, [this](int index) {
        change([this, value = m_box->itemData(index)](void* to) { m_by.put(to, value); });
        this->model().endMerge();
    });
}

void ChoiceEditor::show(bool) {
    const QVariant value = m_by.get(owner());
    if (m_box->findData(value) < 0) {
        m_box->addItem(m_by.text ? m_by.text(value) : value.toString(), value);
    }
    m_box->setCurrentIndex(m_box->findData(value));
}

void ChoiceEditor::retranslate() {
    const QVariant current = m_box->currentData();
    m_box->clear();
    for (const Option& option : m_by.options()) {
        m_box->addItem(option.text, option.value);
    }
    m_box->setCurrentIndex(m_box->findData(current));
}

BooleanEditor::BooleanEditor(const std::string& path, const Field& field, FormModel& model,
                             QWidget* parent)
    : FieldEditor(path, field, model), m_box(new QCheckBox(parent)) {
    connect(m_box, &QCheckBox::clicked, this, [this](bool checked) {
        change([this, checked](void* to) { this->field().as<bool>(to) = checked; });
    });
}

void BooleanEditor::show(bool) {
    m_box->setChecked(field().as<bool>(owner()));
}

void BooleanEditor::retranslate() {
    m_box->setText(tr("yes"));
}

} // namespace sparkout
