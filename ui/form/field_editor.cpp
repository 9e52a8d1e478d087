// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/field_editor.h"

#include "ui/form/choice_editor.h"
#include "ui/form/number_editor.h"
#include "ui/form/numbers_editor.h"
#include "ui/form/text_editor.h"
#include "ui/text/field_text.h"

#include <QComboBox>
#include <QKeyEvent>

#include <utility>

namespace sparkout {

FieldEditor::FieldEditor(std::string path, const Field& field, FormModel& model)
    : m_path(std::move(path)), m_field(field), m_model(model) {}

void FieldEditor::setIssue(const Remark& issue) {
    m_issue = issue;
    emit remarkChanged();
}

void FieldEditor::describe(const QString& name, const QString& hint, const QString& plain) {
    widget()->setObjectName(QString::fromStdString(m_path));
    widget()->setAccessibleName(name);
    widget()->setToolTip(hint);
    if (auto* number = qobject_cast<NumberField*>(widget())) {
        number->setHint(plain);
    } else {
        widget()->setAccessibleDescription(plain);
    }
}

bool FieldEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_model.hasHistory()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && qobject_cast<QComboBox*>(watched)) {
        event->ignore();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

bool FieldEditor::changedFromDefault() const {
    return !isDefault(m_field, owner());
}

void FieldEditor::resetToDefault() {
    m_model.endMerge();
    change([this](void* to) { setDefault(m_field, to); });
    m_model.endMerge();
    dropRefusal();
}

std::unique_ptr<FieldEditor> makeEditor(const std::string& path, const Field& field,
                                        FormModel& model, QWidget* parent, const SpecOf& spec) {
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
        return std::make_unique<NumberEditor>(path, field, model, parent, spec);
    case Kind::choice:
        return std::make_unique<ChoiceEditor>(path, field, model, parent,
                                              ChoiceEditor::choicesOf(field));
    case Kind::boolean: return std::make_unique<BooleanEditor>(path, field, model, parent);
    case Kind::text: return std::make_unique<TextEditor>(path, field, model, parent);
    case Kind::numberList:
    case Kind::optionalNumberList:
    case Kind::levels: return std::make_unique<NumbersEditor>(path, field, model, parent, spec);
    default: return nullptr;
    }
}

} // namespace sparkout
