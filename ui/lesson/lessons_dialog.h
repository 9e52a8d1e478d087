// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QDialog>

#include <vector>

class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTextBrowser;

namespace sparkout {

/// The available laboratory works, the shipped ones and the user's own, each with its aim, steps
/// and points.
class LessonsDialog : public QDialog {
    Q_OBJECT

public:
    /// @param settingsFolder contains the folder of the user's own; empty: none
    explicit LessonsDialog(const QString& settingsFolder, QWidget* parent = nullptr);

    [[nodiscard]] QString chosen() const; ///< path of the lesson; may be empty

    /// Paths of the shipped lessons in the resources, in order.
    [[nodiscard]] static QStringList paths();

private:
    void showChosen();

    struct Entry {
        QString path;
        Lesson lesson;
    };
    std::vector<Entry> m_entries;
    QListWidget* m_list;
    QTextBrowser* m_about;
};

/// Asks for the student and the variant of a work.
class StudentDialog : public QDialog {
    Q_OBJECT

public:
    /// Begins with the last entries.
    StudentDialog(const Lesson& lesson, const QString& name, const QString& group, QWidget* parent);

    [[nodiscard]] QString name() const;
    [[nodiscard]] QString group() const;
    [[nodiscard]] int variant() const; ///< counted from 1

    static constexpr int mostVariants = 100;

private:
    void showWhole();

    QLineEdit* m_name;
    QLineEdit* m_group;
    QSpinBox* m_variant;
    QPushButton* m_begin = nullptr;
};

} // namespace sparkout
