// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/choice_editor.h"

#include "ui/session/document.h"
#include "ui/text/texts.h"

#include <QSignalBlocker>
#include <QWheelEvent>

namespace sparkout {

void StillComboBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

ChoiceEditor::ChoiceEditor(const std::string& path, const Field& field, Document& document,
                           QWidget* parent)
    : FieldEditor(path, field, document), m_box(new StillComboBox(parent)) {
    connect(m_box, &QComboBox::activated, this, [this] {
        const int value = m_box->currentData().toInt();
        change([this, value](void* to) { this->field().setChoice(to, value); });
        this->document().endMerge();
    });
}

void ChoiceEditor::fill() {
    m_box->clear();
    for (int i = 0; i < static_cast<int>(field().choices.size()); ++i) {
        m_box->addItem(choiceText(field().choices[std::size_t(i)].label), i);
    }
}

void ChoiceEditor::show(bool) {
    const int value = field().getChoice(owner());
    m_box->setCurrentIndex(m_box->findData(value));
    m_box->setToolTip(m_box->currentText());
}

void ChoiceEditor::retranslate() {
    const QVariant current = m_box->currentData();
    fill();
    m_box->setCurrentIndex(m_box->findData(current));
    m_box->setToolTip(m_box->currentText());
}

BooleanEditor::BooleanEditor(const std::string& path, const Field& field, Document& document,
                             QWidget* parent)
    : FieldEditor(path, field, document), m_box(new QCheckBox(parent)) {
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
