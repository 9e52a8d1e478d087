// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/lesson/edit/value_widgets.h"

#include <QWidget>

#include <string>
#include <string_view>
#include <vector>

class QFormLayout;
class QHBoxLayout;

namespace sparkout {

/// A struct of the lesson being edited as a form, made from its table: values, texts in both
/// languages, optional objects, lists of objects. Each widget has the path of its value as its
/// name.
class StructForm : public QWidget {
    Q_OBJECT

public:
    struct Subject {
        const StructInfo& table;
        std::string path; ///< in the file
        ValueWidgets::Reach reach;
        std::vector<std::string_view> keys = {}; ///< shown members; empty: all
    };

    StructForm(LessonDraft& draft, Subject subject, QWidget* parent = nullptr);

private:
    using Row = ValueWidgets::Row;

    void build();
    void refresh();
    void addStruct(QFormLayout& form, const Subject& subject);
    void addGoal(QFormLayout& form, const Subject& subject);
    void addVaried(QFormLayout& form, const Subject& subject);
    void addRow(QFormLayout& form, const Row& row);
    void addTexts(QFormLayout& form, const Row& row);
    void addObject(QFormLayout& form, const Row& row);
    void addItems(QFormLayout& form, const Row& row);
    void addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count);
    void addItemButtons(QHBoxLayout& line, const Row& row, std::size_t index, std::size_t count,
                        const QString& title);
    [[nodiscard]] QWidget* levelsOf(const Row& row, std::size_t index);

    LessonDraft& m_draft;
    Subject m_subject;
    ValueWidgets m_values;
    QWidget* m_body = nullptr;
    std::string m_shape; ///< describes which widgets exist
};

} // namespace sparkout
