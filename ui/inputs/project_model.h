// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/form/field_editor.h"

#include <optional>

namespace sparkout {

class Document;

/// The inputs of a document's current surface.
class ProjectModel : public FormModel {
    Q_OBJECT

public:
    explicit ProjectModel(Document& document, QObject* parent = nullptr);

    [[nodiscard]] Document& document() const { return m_document; }
    /// A struct that is not given answers with its defaults.
    [[nodiscard]] const void* ownerOf(const std::string& path) const override;
    void change(const std::string& path, const Change& set, bool merges) override;
    [[nodiscard]] bool hasHistory() const override { return true; }
    void endMerge() override;
    [[nodiscard]] bool fits(const std::string& path, const Change& set) const override;
    [[nodiscard]] const Project* project() const override;
    [[nodiscard]] bool isOpen(const std::string& path) const override;
    void withdraw(const std::string& path) override;

private:
    [[nodiscard]] const char* labelOf(const std::string& path) const;
    [[nodiscard]] std::optional<Project> changedProject(const std::string& path,
                                                        const Change& set) const;

    Document& m_document;
};

/// The editor of an input by its kind and path; null for kinds without one.
[[nodiscard]] std::unique_ptr<FieldEditor>
makeInputEditor(const std::string& path, const Field& field, ProjectModel& model, QWidget* parent);

} // namespace sparkout
