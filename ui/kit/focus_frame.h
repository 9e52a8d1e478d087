// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointer>
#include <QWidget>

namespace sparkout {

/// A frame around the widget with the focus, for users who move through the panels by F6; it helps
/// where the style marks the focus faintly or not at all: a list without a current row, a plot, a
/// tab bar.
class FocusFrame : public QWidget {
    Q_OBJECT

public:
    /// Frames a widget in its window, replacing an earlier frame.
    static void showRound(QWidget& widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    explicit FocusFrame(QWidget& window);
    void follow(QWidget& widget);
    void leave();
    void place();

    QPointer<QWidget> m_widget;         ///< null: no frame
    QList<QPointer<QWidget>> m_watched; ///< the widget and its parents, which may outlive it
};

} // namespace sparkout
