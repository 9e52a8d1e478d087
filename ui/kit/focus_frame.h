// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointer>
#include <QWidget>

namespace sparkout {

/// A frame round the widget that has the focus, as long as it has it. Whoever goes through the
/// panels by F6 sees where he has come to, also where the style marks a focus faintly or not at
/// all: a list without a current row, a plot, a tab bar.
class FocusFrame : public QWidget {
    Q_OBJECT

public:
    /// Frames a widget in its window, in place of the frame that was there.
    static void showRound(QWidget& widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    explicit FocusFrame(QWidget& window);
    void follow(QWidget& widget);
    void leave();
    void place();

    QPointer<QWidget> m_widget;         ///< null: nothing is framed
    QList<QPointer<QWidget>> m_watched; ///< it and what it stands in, which may outlive it
};

} // namespace sparkout
