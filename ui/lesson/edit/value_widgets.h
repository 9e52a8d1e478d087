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

/// The widgets of single values of the edited lesson, by their rows: each shows and changes its
/// value, and is named by its path.
class ValueWidgets : public QObject {
    Q_OBJECT

public:
    /// Finds a struct in a lesson; null if it does not exist.
    using Reach = std::function<void*(Lesson& lesson)>;
    /// A value and its struct.
    struct Row {
        const StructInfo& table;
        const Field& field;
        std::string path;
        Reach reach;
    };

    ValueWidgets(LessonDraft& draft, QObject* parent);

    /// Null if the row is not a value, or if there is no choice.
    [[nodiscard]] QWidget* make(const Row& row);
    /// The value of an input in its own form: a number, a choice or a text.
    [[nodiscard]] QWidget* makeValue(const StructInfo& info, const std::string& path,
                                     const Reach& reach);
    [[nodiscard]] QString labelOf(const Row& row) const; ///< label with the unit

    void refresh();                   ///< shows the current values
    void clear() { m_shows.clear(); } ///< the widgets go
    /// Shows part of a struct, now and whenever the lesson changes.
    void showBy(const Row& row, std::function<void(const void* owner)> show);
    void change(const Row& row, const std::function<void(void* owner)>& set, bool merges = true);
    /// Sets path, label and hint of its row.
    void name(QWidget& widget, const Row& row, const std::string& more = {});
    void watch(QWidget& widget); ///< passes undo and the wheel on
    [[nodiscard]] const void* ownerOf(const Reach& reach) const;

    /// Whether the number is that of a surface or step of the lesson, chosen by name.
    [[nodiscard]] static bool isNumbered(const StructInfo& info, const Field& field);
    /// Whether it names an input, which determines the widgets of its values.
    [[nodiscard]] static bool isInput(const StructInfo& info, const Field& field);
    /// "LOCATION: reason" for refused texts in number fields.
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
    [[nodiscard]] std::vector<Option> optionsFor(const Row& row) const; ///< for a text; empty: any
    [[nodiscard]] std::vector<Numbered> numberedFor(const Row& row) const;
    /// The project's input whose value a number of the lesson is.
    [[nodiscard]] std::optional<NumberInput> inputOf(const Row& row) const;
    [[nodiscard]] NumberSpec specOf(const Row& row) const;

    LessonDraft& m_draft;
    std::vector<std::function<void()>> m_shows;
};

} // namespace sparkout
