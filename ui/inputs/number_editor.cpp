// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/number_editor.h"

#include "ui/session/document.h"
#include "ui/session/member.h"

namespace sparkout {

NumberEditor::NumberEditor(const std::string& path, const Field& field, Document& document,
                           QWidget* parent)
    : FieldEditor(path, field, document), m_field(new NumberField(NumberSpec::of(field), parent)) {
    m_field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(m_field, &NumberField::valueEdited, this, &NumberEditor::store);
    connect(m_field, &NumberField::remarkChanged, this, &FieldEditor::remarkChanged);
    connect(m_field, &QLineEdit::editingFinished, this, [this] { this->document().endMerge(); });
}

std::optional<double> NumberEditor::stored() const {
    return numberIn(field(), owner());
}

void NumberEditor::store() {
    change([this, value = m_field->value()](void* to) { setNumberIn(field(), to, value); });
}

void NumberEditor::show(bool replaced) {
    replaced ? m_field->reset(stored()) : m_field->setValue(stored());
}

QString NumberEditor::refusal() const {
    return m_field->refused() ? m_field->refusal() : QString();
}

} // namespace sparkout
