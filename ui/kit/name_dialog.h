// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace sparkout {

/// Asks for a name, and states for each its effect or why it is refused.
class NameDialog : public QDialog {
    Q_OBJECT

public:
    /// A message about a name, and whether it is accepted.
    struct Answer {
        QString remark = {};
        bool allowed = true;
    };
    using Judge = std::function<Answer(const QString& name)>;

    /// @param accept text of the button that accepts the name
    /// @param judge judges a name that is not empty
    NameDialog(const QString& title, const QString& accept, const QString& name, Judge judge,
               QWidget* parent);

    [[nodiscard]] QString name() const; ///< trimmed

private:
    void follow();

    Judge m_judge;
    QLineEdit* m_name;
    QLabel* m_remark;
    QPushButton* m_accept;
};

} // namespace sparkout
