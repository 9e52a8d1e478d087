// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/field_editor.h"

#include "core/project/member.h"
#include "core/project/part.h"
#include "core/study/operation.h"
#include "ui/inputs/editors/choice_editor.h"
#include "ui/inputs/editors/number_editor.h"
#include "ui/inputs/editors/numbers_editor.h"
#include "ui/inputs/editors/radii_editor.h"
#include "ui/inputs/editors/range_editor.h"
#include "ui/inputs/editors/rows_editor.h"
#include "ui/inputs/editors/text_editor.h"
#include "ui/session/document.h"
#include "ui/text/defaults.h"

#include <QKeyEvent>

namespace sparkout {

FieldEditor::FieldEditor(std::string path, const Field& field, Document& document)
    : m_path(std::move(path)), m_field(field), m_document(document) {}

void FieldEditor::setIssue(const Remark& issue) {
    m_issue = issue;
    emit remarkChanged();
}

bool FieldEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

std::optional<Project> FieldEditor::changedProject(const std::function<void(void*)>& set) const {
    const Project& before = m_document.project();
    Project after = before;
    const Member member = findMember(after, m_path, true);
    if (!member) {
        return std::nullopt;
    }
    set(member.owner);
    if (after.operation != before.operation) {
        return withOperation(before, after.operation, m_document.lastWith(after.operation));
    }
    if (after.sections != before.sections) {
        // Compares with the value before typing began: 12 must not go through 1.
        const QString key = QString::fromStdString(m_path);
        return withSections(m_document.beforeEditsOf(key), after.sections);
    }
    return after.part->surface != before.part->surface ? withComputable(std::move(after)) : after;
}

void FieldEditor::change(const std::function<void(void*)>& set) {
    if (auto after = changedProject(set)) {
        m_document.edit(std::move(*after), {"Input", m_field.label},
                        QString::fromStdString(m_path));
    }
}

bool FieldEditor::fits(const std::function<void(void*)>& set) const {
    const auto after = changedProject(set);
    return !after || !breaksRules(m_document.project(), *after);
}

bool FieldEditor::changedFromDefault() const {
    return !isDefault(m_field, owner());
}

void FieldEditor::resetToDefault() {
    m_document.endMerge();
    change([this](void* to) { setDefault(m_field, to); });
    m_document.endMerge();
    dropRefusal();
}

const void* FieldEditor::owner() const {
    return findMember(m_document.project(), m_path).owner;
}

std::unique_ptr<FieldEditor> makeEditor(const std::string& path, const Field& field,
                                        Document& document, QWidget* parent) {
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
        return std::make_unique<NumberEditor>(path, field, document, parent);
    case Kind::choice: return std::make_unique<ChoiceEditor>(path, field, document, parent);
    case Kind::boolean: return std::make_unique<BooleanEditor>(path, field, document, parent);
    case Kind::text:
        if (path == "/notes") {
            return std::make_unique<NotesEditor>(path, field, document, parent);
        }
        return std::make_unique<TextEditor>(path, field, document, parent);
    case Kind::optionalNumberList:
        if (path == "/part/radii_um") {
            return std::make_unique<RadiiEditor>(path, field, document, parent);
        }
        if (field.count == 3) {
            return std::make_unique<RangeEditor>(path, field, document, parent);
        }
        return std::make_unique<NumbersEditor>(path, field, document, parent);
    case Kind::numberList:
    case Kind::levels: return std::make_unique<NumbersEditor>(path, field, document, parent);
    case Kind::numberRows: return std::make_unique<RowsEditor>(path, field, document, parent);
    default: return nullptr;
    }
}

} // namespace sparkout
