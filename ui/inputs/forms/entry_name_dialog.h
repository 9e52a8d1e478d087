// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace sparkout {

/// Asks for the name of an entry of the user's catalogue.
class EntryNameDialog : public QDialog {
    Q_OBJECT

public:
    /// A message about a name, and whether it is accepted.
    struct Answer {
        QString remark;
        bool allowed = true;
    };

    EntryNameDialog(const QString& title, const QString& name,
                    std::function<Answer(const QString&)> judge, QWidget* parent);

    [[nodiscard]] QString name() const; ///< trimmed

private:
    void judge();

    std::function<Answer(const QString&)> m_judge;
    QLineEdit* m_name;
    QLabel* m_remark;
    QPushButton* m_keep;
};

} // namespace sparkout
