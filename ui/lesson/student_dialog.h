// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace sparkout {

/// Asks once who does a work, and which variant of it.
class StudentDialog : public QDialog {
    Q_OBJECT

public:
    /// With what was given the last time.
    StudentDialog(const Lesson& lesson, const QString& name, const QString& group, QWidget* parent);

    [[nodiscard]] QString name() const;
    [[nodiscard]] QString group() const;
    [[nodiscard]] int variant() const; ///< from 1

    static constexpr int mostVariants = 100;

private:
    void showWhole();

    QLineEdit* m_name;
    QLineEdit* m_group;
    QSpinBox* m_variant;
    QPushButton* m_begin = nullptr;
};

} // namespace sparkout
