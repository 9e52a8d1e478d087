// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/number_editor.h"

#include "ui/session/document.h"

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
    const void* const from = owner();
    switch (field().kind) {
    case Kind::number: return field().as<double>(from);
    case Kind::integer: return field().as<int>(from);
    case Kind::optionalInteger: {
        const auto& value = field().as<std::optional<int>>(from);
        return value ? std::optional<double>(*value) : std::nullopt;
    }
    default: return field().as<std::optional<double>>(from);
    }
}

void NumberEditor::store() {
    const std::optional<double> value = m_field->value();
    change([this, value](void* to) {
        switch (field().kind) {
        case Kind::number: field().as<double>(to) = value.value_or(0); break;
        case Kind::integer: field().as<int>(to) = static_cast<int>(value.value_or(0)); break;
        case Kind::optionalInteger:
            field().as<std::optional<int>>(to) =
                value ? std::optional<int>(static_cast<int>(*value)) : std::nullopt;
            break;
        default: field().as<std::optional<double>>(to) = value;
        }
    });
}

void NumberEditor::show(bool replaced) {
    replaced ? m_field->reset(stored()) : m_field->setValue(stored());
}

QString NumberEditor::refusal() const {
    return m_field->refused() ? m_field->refusal() : QString();
}

} // namespace sparkout
