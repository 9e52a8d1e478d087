// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace sparkout {

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
