// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/choice_editor.h"
#include "ui/form/mark.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class QFormLayout;
class QHBoxLayout;

namespace sparkout {

struct Leaf;

/// A struct as a form, made from its table: values, objects that may be there, lists of objects.
/// Labels, units, hints and ranges are those of the rows. Each widget has the path of its value as
/// its name.
class StructForm : public QWidget {
    Q_OBJECT

public:
    /// What is shown: the struct at a path below the root of the model.
    struct Subject {
        const StructInfo& table;
        std::string path;
        std::vector<std::string_view> keys = {}; ///< what is shown of it; none: all
    };

    StructForm(FormModel& model, Subject subject, QWidget* parent = nullptr);
    void build(); ///< makes its widgets, by what a derived form makes in its own way

    /// The form of a struct that is changed in its place.
    template <class T>
    [[nodiscard]] static StructForm* over(T& value, QWidget* parent) {
        return over(tableOf<T>(), &value, parent);
    }

    /// What stands in the fields and was not taken.
    [[nodiscard]] static std::vector<Refusal> refusals(const QWidget& within);

signals:
    void edited(); ///< another value, or another text that is not taken

protected:
    /// A value: its row, the table of the struct it is in, and its path.
    struct Row {
        const StructInfo& table;
        const Field& field;
        std::string path;
    };

    virtual void addStruct(QFormLayout& form, const Subject& subject);
    virtual void addRow(QFormLayout& form, const Row& row);
    virtual void addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count);
    /// Adds what else stands beside the button of a list, or beside those of one of its items.
    virtual void addBeside(QHBoxLayout&, const Row&, std::optional<std::size_t>) {}
    /// Null where the row has no value, or where there is nothing to choose.
    [[nodiscard]] virtual QWidget* make(const Row& row);
    [[nodiscard]] virtual NumberSpec specOf(const Row& row) const;
    /// The row as its hint describes it.
    [[nodiscard]] virtual Field described(const Row& row) const { return row.field; }
    /// What of a value decides which widgets there are.
    [[nodiscard]] virtual std::string decisiveValue(const Leaf&) const { return {}; }
    virtual void fillNewItem(const Field& list, void* owner) const; ///< the last of the list
    /// How many items a list cannot do without while its struct is there.
    [[nodiscard]] virtual std::size_t leastItems(const Field&) const { return 0; }

    [[nodiscard]] static Row rowOf(const Subject& subject, const Field& field);
    [[nodiscard]] static Row rowOf(const Subject& subject, const char* key);
    [[nodiscard]] QString labelOf(const Row& row) const; ///< with its unit
    /// Names an editor by label and hint of its row, and shows its value; null: there is none.
    QWidget* adopt(const Row& row, std::unique_ptr<FieldEditor> editor);
    [[nodiscard]] QWidget* choiceOf(const Row& row, ChoiceEditor::Choosing by);
    [[nodiscard]] FormModel& model() const { return m_model; }
    void addItemButtons(QHBoxLayout& line, const Row& row, std::size_t index, std::size_t count);
    /// Gives what a new struct cannot do without.
    static void addNeeded(const StructInfo& info, void* owner);

    /// The struct that holds the value; null: it is not there.
    [[nodiscard]] const void* ownerOf(const Row& row) const;
    void change(const Row& row, const FormModel::Change& set); ///< as a step of its own
    /// Shows something of a struct, now and whenever the model changes.
    void showBy(const Row& row, std::function<void(const void* owner)> show);

private:
    [[nodiscard]] static StructForm* over(const StructInfo& table, void* value, QWidget* parent);
    void refresh();
    /// Which widgets there are: by optional objects, items of lists and decisive values.
    [[nodiscard]] std::string shapeOf(const void* owner) const;
    void addObject(QFormLayout& form, const Row& row);
    void addItems(QFormLayout& form, const Row& row);

    FormModel& m_model;
    Subject m_subject;
    QWidget* m_body = nullptr;
    std::string m_shape;
    std::vector<FieldEditor*> m_editors; ///< parts of the body
    std::vector<std::function<void()>> m_shows;
};

} // namespace sparkout
