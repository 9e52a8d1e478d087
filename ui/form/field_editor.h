// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/fields/number_field.h"
#include "ui/form/form_model.h"

#include <QObject>

#include <functional>
#include <memory>
#include <string>

namespace sparkout {

/// One row of a form: shows a member of a model, checks what is typed and passes it on.
class FieldEditor : public QObject {
    Q_OBJECT

public:
    FieldEditor(std::string path, const Field& field, FormModel& model);

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] const Field& field() const { return m_field; }

    [[nodiscard]] virtual QWidget* widget() const = 0;
    [[nodiscard]] virtual QWidget* slider() const { return nullptr; } ///< below the widget
    virtual void show(bool replaced) = 0; ///< the model's value; replaced: drop refused texts
    virtual void retranslate() = 0;
    [[nodiscard]] virtual Remark remark() const { return m_issue; }
    [[nodiscard]] virtual QString refusal() const { return {}; } ///< reason of a refused text
    virtual void dropRefusal() {}                                ///< restores the model's value
    virtual void setIssue(const Remark& issue);
    [[nodiscard]] virtual bool wide() const { return false; }  ///< also covers the unit's column
    [[nodiscard]] virtual bool tall() const { return false; }  ///< whether it is below its label
    [[nodiscard]] virtual bool empty() const { return false; } ///< whether the value is not given

    /// Gives the widget the path as its name, a name for screen readers, and its hint as rich and
    /// as plain text.
    void describe(const QString& name, const QString& hint, const QString& plain);
    [[nodiscard]] bool changedFromDefault() const;
    void resetToDefault(); ///< as a step of the history

signals:
    void remarkChanged();

protected:
    /// Undo and redo belong to the history, not to a watched widget; the wheel scrolls the page and
    /// changes no choice.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void change(const FormModel::Change& set) { m_model.change(m_path, set, true); }
    /// Whether the change would violate no rule that is currently met.
    [[nodiscard]] bool fits(const FormModel::Change& set) const {
        return m_model.fits(m_path, set);
    }
    /// The struct with the member.
    [[nodiscard]] const void* owner() const { return m_model.ownerOf(m_path); }
    [[nodiscard]] FormModel& model() const { return m_model; }

private:
    std::string m_path;
    const Field& m_field;
    FormModel& m_model;
    Remark m_issue;
};

/// The allowed numbers of a row where they are not those of its table.
using SpecOf = std::function<NumberSpec()>;

/// The editor of a row by its kind; null for kinds without one.
[[nodiscard]] std::unique_ptr<FieldEditor> makeEditor(const std::string& path, const Field& field,
                                                      FormModel& model, QWidget* parent,
                                                      const SpecOf& spec = {});

} // namespace sparkout
