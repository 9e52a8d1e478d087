// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace sparkout {

/// Two linked rings beside an input shared by all surfaces of a set-up.
class SharedMark : public QWidget {
    Q_OBJECT

public:
    explicit SharedMark(QWidget* parent = nullptr);

    [[nodiscard]] static QString text(); ///< "for all surfaces"
    void retranslate();
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace sparkout
