// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace sparkout {

/// A dot beside an input that differs from its default; a click restores it.
class ResetMark : public QAbstractButton {
    Q_OBJECT

public:
    explicit ResetMark(QWidget* parent = nullptr);

    void showChanged(bool changed);
    void showDefault(const QString& label, const QString& defaultText);
    [[nodiscard]] QString menuText() const; ///< "Reset to the default (0.3)"

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_default;
};

} // namespace sparkout
