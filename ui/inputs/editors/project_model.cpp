// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/project_model.h"

#include "core/project/member.h"
#include "core/project/part.h"
#include "core/study/operation.h"
#include "ui/form/text_editor.h"
#include "ui/inputs/editors/radii_editor.h"
#include "ui/inputs/editors/range_editor.h"
#include "ui/inputs/editors/rows_editor.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"

#include <utility>

namespace sparkout {

ProjectModel::ProjectModel(Document& document, QObject* parent)
    : FormModel(parent), m_document(document) {
    connect(&document, &Document::changed, this, &FormModel::changed);
    connect(&document, &Document::saved, this, &FormModel::saved);
}

const void* ProjectModel::ownerOf(const std::string& path) const {
    return findMember(m_document.project(), path).owner;
}

const char* ProjectModel::labelOf(const std::string& path) const {
    return findMember(m_document.project(), path).field->label;
}

std::optional<Project> ProjectModel::changedProject(const std::string& path,
                                                    const Change& set) const {
    const Project& before = m_document.project();
    Project after = before;
    const Member member = findMember(after, path, true);
    if (!member) {
        return std::nullopt;
    }
    set(member.owner);
    if (after.operation != before.operation) {
        return withOperation(before, after.operation, m_document.lastWith(after.operation));
    }
    if (after.sections != before.sections) {
        // Compares with the value before typing began: 12 must not go through 1.
        return withSections(m_document.beforeEditsOf(QString::fromStdString(path)), after.sections);
    }
    return after.part->surface != before.part->surface ? withComputable(std::move(after)) : after;
}

void ProjectModel::change(const std::string& path, const Change& set, bool merges) {
    if (auto after = changedProject(path, set)) {
        m_document.edit(std::move(*after), {"Input", labelOf(path)},
                        merges ? QString::fromStdString(path) : QString());
    }
}

void ProjectModel::endMerge() {
    m_document.endMerge();
}

bool ProjectModel::fits(const std::string& path, const Change& set) const {
    const auto after = changedProject(path, set);
    return !after || !breaksRules(m_document.project(), *after);
}

const Project* ProjectModel::project() const {
    return &m_document.project();
}

bool ProjectModel::isOpen(const std::string& path) const {
    return m_document.isOpen(path);
}

void ProjectModel::withdraw(const std::string& path) {
    m_document.withdraw(path, {"Input", labelOf(path)});
}

std::unique_ptr<FieldEditor> makeInputEditor(const std::string& path, const Field& field,
                                             ProjectModel& model, QWidget* parent) {
    if (path == "/notes") {
        auto notes = std::make_unique<NotesEditor>(path, field, model, parent);
        setTextLines(*notes->widget(), 5, 10);
        return notes;
    }
    if (path == "/part/radii_um") {
        return std::make_unique<RadiiEditor>(path, field, model, parent);
    }
    if (field.kind == Kind::optionalNumberList && field.count == 3) {
        return std::make_unique<RangeEditor>(path, field, model, parent);
    }
    if (field.kind == Kind::numberRows) {
        return std::make_unique<RowsEditor>(path, field, model, parent);
    }
    return makeEditor(path, field, model, parent);
}

} // namespace sparkout
