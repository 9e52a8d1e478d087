// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"

#include <QWidget>

namespace sparkout {

/// A legend beside the plot that wraps its entries over several lines. A click hides or shows a
/// curve, Ctrl+click shows only this one; by keyboard: arrows choose, Space, Ctrl+Space.
class LegendStrip : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setEntries(LegendEntries entries);
    [[nodiscard]] const LegendEntries& entries() const { return m_entries; }
    [[nodiscard]] QRect entryRect(int index) const; ///< in widget coordinates
    void retranslate();

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void toggled(int key);   ///< hide or show this curve
    void onlyAsked(int key); ///< show only this one

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int entryAt(const QPoint& at) const; ///< −1: none that can be clicked
    void activate(int index, bool only);
    void choose(int step);
    void tell();

    LegendEntries m_entries;
    int m_current = -1; ///< chosen by keyboard
};

} // namespace sparkout
