// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "ui/fields/mark.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QWidget;

namespace sparkout {

class Document;

/// Shows one member of the project and passes edits to the document.
class FieldEditor : public QObject {
    Q_OBJECT

public:
    FieldEditor(std::string path, const Field& field, Document& document);

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] const Field& field() const { return m_field; }

    [[nodiscard]] virtual QWidget* widget() const = 0;
    [[nodiscard]] virtual QWidget* slider() const { return nullptr; } ///< below the widget
    virtual void show(bool replaced) = 0; ///< the document's value; replaced: drop refused texts
    virtual void retranslate() = 0;
    [[nodiscard]] virtual Remark remark() const { return m_issue; }
    [[nodiscard]] virtual QString refusal() const { return {}; } ///< reason of a refused text
    virtual void dropRefusal() {}                                ///< restores the document's value
    virtual void setIssue(const Remark& issue);
    [[nodiscard]] virtual bool wide() const { return false; }  ///< also covers the unit's column
    [[nodiscard]] virtual bool tall() const { return false; }  ///< whether it is below its label
    [[nodiscard]] virtual bool empty() const { return false; } ///< whether the value is not given

    [[nodiscard]] bool changedFromDefault() const;
    void resetToDefault(); ///< as a step of the history

signals:
    void remarkChanged();

protected:
    /// Undo and redo belong to the document, not to a watched widget.
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Changes the member in a copy of the project and passes it to the document.
    void change(const std::function<void(void* owner)>& set);
    /// Whether the change would violate no rule that is currently met.
    [[nodiscard]] bool fits(const std::function<void(void* owner)>& set) const;
    [[nodiscard]] const void* owner() const; ///< the struct with the member
    [[nodiscard]] Document& document() const { return m_document; }

private:
    [[nodiscard]] std::optional<Project>
    changedProject(const std::function<void(void* owner)>& set) const;

    std::string m_path;
    const Field& m_field;
    Document& m_document;
    Remark m_issue;
};

/// The editor of a row by its kind; null for kinds without one.
[[nodiscard]] std::unique_ptr<FieldEditor> makeEditor(const std::string& path, const Field& field,
                                                      Document& document, QWidget* parent);

} // namespace sparkout
