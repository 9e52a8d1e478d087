// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "ui/form/number_field.h"
#include "ui/table/pasted_cells.h"

#include <QLineEdit>
#include <QObject>
#include <QPlainTextEdit>

#include <functional>
#include <memory>
#include <string>

namespace sparkout {

/// The values that a form shows and changes, each at the path of its member.
class FormModel : public QObject {
    Q_OBJECT

public:
    using Change = std::function<void(void* owner)>;

    using QObject::QObject;

    /// The struct with the member at a path; null: it is not there.
    [[nodiscard]] virtual const void* ownerOf(const std::string& path) const = 0;
    /// Changes the struct with the member at a path. In a history, successive changes at the same
    /// path are one step if they merge.
    virtual void change(const std::string& path, const Change& set, bool merges) = 0;
    /// Whether undo and redo go through all changes; without a history each field has its own.
    [[nodiscard]] virtual bool hasHistory() const = 0;
    virtual void endMerge() {} ///< makes the next change a step of its own

    /// Whether a change would violate no rule that is currently met.
    [[nodiscard]] virtual bool fits(const std::string&, const Change&) const { return true; }
    /// The project whose inputs the values are; null: they are no inputs.
    [[nodiscard]] virtual const Project* project() const { return nullptr; }
    /// Whether a number is still to be entered.
    [[nodiscard]] virtual bool isOpen(const std::string&) const { return false; }
    /// Marks a number as still to be entered.
    virtual void withdraw(const std::string&) {}

signals:
    void changed(); ///< another value
    void saved();
};

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

class CellsLineEdit;

/// A member of several numbers in one line of text. An unreadable text stays, marked with its
/// reason, while the model keeps the last valid value.
class LineEditor : public FieldEditor {
    Q_OBJECT

public:
    LineEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

protected:
    [[nodiscard]] virtual QString storedText() const = 0; ///< text of the model's value
    /// Whether a text means the model's value.
    [[nodiscard]] virtual bool isStored(const QString& text) const = 0;
    /// Passes a text to the model, or returns the reason for refusing it.
    [[nodiscard]] virtual QString accept(const QString& text) = 0;
    /// The text for several pasted cells, or why they are invalid.
    struct CellsText {
        QString text = {};
        QString fault = {};
    };
    [[nodiscard]] virtual CellsText textOf(const PastedCells& cells) const = 0;

private:
    void take();
    void takeCells(const PastedCells& cells); ///< replaces the whole contents, or nothing
    void refuse(const QString& reason);
    void forgetPaste();

    CellsLineEdit* m_line;
    QString m_notPasted; ///< why cells were refused, until the next action
    QString m_refused;   ///< why the text was refused; empty: accepted
    QString m_kept;      ///< the model's value when that happened
};

/// A line of text.
class TextEditor : public FieldEditor {
    Q_OBJECT

public:
    TextEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_line; }
    void show(bool replaced) override;
    void retranslate() override {}
    [[nodiscard]] bool wide() const override { return true; }

private:
    QLineEdit* m_line;
};

/// A text of several lines.
class NotesEditor : public FieldEditor {
    Q_OBJECT

public:
    NotesEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_text; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take();
    void refuse(const QString& reason);
    [[nodiscard]] static QString tooLong(std::size_t bytes);
    [[nodiscard]] QString stored() const;
    [[nodiscard]] QString typed() const;

    QPlainTextEdit* m_text;
    QString m_refused; ///< why the shown text was refused; empty: accepted
    QString m_kept;    ///< the model's text when that happened
};

} // namespace sparkout
