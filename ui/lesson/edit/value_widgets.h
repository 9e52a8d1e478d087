// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/lesson.h"
#include "core/project/number_input.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace sparkout {

class LessonDraft;
struct NumberSpec;

/// The widgets of single values of the lesson being edited, by their rows: each shows its value,
/// changes it, and has its path as its name.
class ValueWidgets : public QObject {
    Q_OBJECT

public:
    /// Finds a struct in a lesson; null: it is not there.
    using Reach = std::function<void*(Lesson& lesson)>;
    /// A value, and the struct it is in.
    struct Row {
        const StructInfo& table;
        const Field& field;
        std::string path;
        Reach reach;
    };

    ValueWidgets(LessonDraft& draft, QObject* parent);

    /// Null where the row is no value, or where there is nothing to choose.
    [[nodiscard]] QWidget* make(const Row& row);
    /// The value of an input, as the input takes it: a number, a choice or a text.
    [[nodiscard]] QWidget* makeValue(const StructInfo& info, const std::string& path,
                                     const Reach& reach);
    [[nodiscard]] QString labelOf(const Row& row) const; ///< with its unit

    void refresh();                   ///< shows the values as they are now
    void clear() { m_shows.clear(); } ///< the widgets go
    /// Shows something of a struct, now and whenever the lesson changes.
    void showBy(const Row& row, std::function<void(const void* owner)> show);
    void change(const Row& row, const std::function<void(void* owner)>& set, bool merges = true);
    /// Gives it path, label and hint of its row.
    void name(QWidget& widget, const Row& row, const std::string& more = {});
    void watch(QWidget& widget); ///< undo and the wheel are not its own
    [[nodiscard]] const void* ownerOf(const Reach& reach) const;

    /// Whether the number is that of a surface or step of the lesson, chosen by its name.
    [[nodiscard]] static bool isNumbered(const StructInfo& info, const Field& field);
    /// Whether it names an input, which says what widgets its values have.
    [[nodiscard]] static bool isInput(const StructInfo& info, const Field& field);
    /// "LOCATION: reason" of what stands in number fields and was not taken.
    [[nodiscard]] static QStringList refusals(const QWidget& within);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Option {
        QString text;
        std::string value;
    };
    struct Numbered {
        QString text;
        int number;
    };

    [[nodiscard]] QWidget* numberOf(const Row& row);
    [[nodiscard]] QWidget* numbersOf(const Row& row);
    [[nodiscard]] QWidget* tickOf(const Row& row);
    [[nodiscard]] QWidget* lineOf(const Row& row);
    [[nodiscard]] QWidget* choiceOf(const Row& row);
    [[nodiscard]] QWidget* optionsOf(const Row& row, const std::vector<Option>& options);
    [[nodiscard]] QWidget* placeOf(const Row& row);
    [[nodiscard]] QWidget* numberedOf(const Row& row, const std::vector<Numbered>& numbered);
    [[nodiscard]] std::vector<Option> optionsFor(const Row& row) const; ///< of a text; none: any
    [[nodiscard]] std::vector<Numbered> numberedFor(const Row& row) const;
    /// The input of the project that a number of the lesson is a value of.
    [[nodiscard]] std::optional<NumberInput> inputOf(const Row& row) const;
    [[nodiscard]] NumberSpec specOf(const Row& row) const;

    LessonDraft& m_draft;
    std::vector<std::function<void()>> m_shows;
};

} // namespace sparkout
