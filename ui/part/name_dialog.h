// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <functional>

class QLineEdit;

namespace sparkout {

/// Asks for a unique name of a surface.
class NameDialog : public QDialog {
    Q_OBJECT

public:
    NameDialog(const QString& name, std::function<bool(const QString&)> isFree,
               QWidget* parent = nullptr);

    [[nodiscard]] QString name() const;

private:
    QLineEdit* m_name;
};

} // namespace sparkout
