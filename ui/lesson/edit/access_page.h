// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QWidget>

#include <map>
#include <optional>
#include <string>

class QComboBox;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace sparkout {

class LessonDraft;
class LessonForm;

/// Sets a student's access to the inputs in a step: a searchable tree of all inputs with their
/// names in the forms; a choice applies to the selected ones and those below them.
class AccessPage : public QWidget {
    Q_OBJECT

public:
    AccessPage(LessonDraft& draft, std::size_t step, QWidget* parent = nullptr);

private:
    [[nodiscard]] const LessonStep* now() const; ///< null: the step was removed
    void fill();
    void addInput(const std::string& path);
    void show();
    void search(const QString& text);
    void give(std::optional<Access> access);

    LessonDraft& m_draft;
    std::size_t m_step;
    LessonForm* m_others; ///< what holds for the inputs that are not named
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QComboBox* m_access; ///< access to the selected inputs
    std::map<std::string, QTreeWidgetItem*> m_items;
};

} // namespace sparkout
