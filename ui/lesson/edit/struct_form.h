// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/lesson.h"

#include <QWidget>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

class QComboBox;
class QFormLayout;
class QGridLayout;

namespace sparkout {

class LessonDraft;

/// A struct of the lesson being edited as a form, made from its table: values, texts in both
/// languages, objects that may be there, lists of objects. Each widget has the path of its value as
/// its name.
class StructForm : public QWidget {
    Q_OBJECT

public:
    /// Finds the struct in a lesson; null: it is not there.
    using Reach = std::function<void*(Lesson& lesson)>;
    struct Subject {
        const StructInfo& table;
        std::string path; ///< in the file
        Reach reach;
        std::vector<std::string_view> keys = {}; ///< what is shown of it; none: all
        std::size_t step = 0;                    ///< that it belongs to
    };

    StructForm(LessonDraft& draft, Subject subject, QWidget* parent = nullptr);

    /// "LOCATION: reason" of what stands in number fields and was not taken.
    [[nodiscard]] static QStringList refusals(const QWidget& within);

protected:
    /// Undo and redo are of the lesson, not of the watched widget.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A value, and the struct it is in.
    struct Row {
        const StructInfo& table;
        const Field& field;
        std::string path;
        Reach reach;
    };
    struct Option {
        QString text;
        std::string value;
    };

    void build();
    void refresh();
    void addStruct(QFormLayout& form, const Subject& subject);
    void addGoal(QFormLayout& form, const Subject& subject);
    void addRow(QFormLayout& form, const Row& row);
    [[nodiscard]] QWidget* numberOf(const Row& row);
    [[nodiscard]] QWidget* numbersOf(const Row& row);
    [[nodiscard]] QWidget* tickOf(const Row& row);
    [[nodiscard]] QWidget* lineOf(const Row& row);
    [[nodiscard]] QWidget* choiceOf(const Row& row);
    [[nodiscard]] QWidget* optionsOf(const Row& row, const std::vector<Option>& options);
    [[nodiscard]] QWidget* placeOf(const Row& row);
    void addTexts(QFormLayout& form, const Row& row);
    void addObject(QFormLayout& form, const Row& row);
    void addItems(QFormLayout& form, const Row& row);
    void addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count);
    [[nodiscard]] std::vector<Option> optionsFor(const Row& row) const; ///< of a text; none: any
    [[nodiscard]] const void* ownerOf(const Reach& reach) const;
    void change(const Row& row, const std::function<void(void* owner)>& set, bool merges = true);
    void name(QWidget& widget, const Row& row, const std::string& more = {}) const;
    void showBy(const Row& row, std::function<void(const void* owner)> show);

    LessonDraft& m_draft;
    Subject m_subject;
    QWidget* m_body = nullptr;
    std::string m_shape; ///< which objects are there, how many items lists have
    std::vector<std::function<void()>> m_shows;
};

/// The inputs of a project that the forms show, with those above them: paths in the file.
[[nodiscard]] std::vector<std::string> formInputs(const Project& project);

} // namespace sparkout
