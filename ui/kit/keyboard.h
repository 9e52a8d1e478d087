// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointer>
#include <QString>
#include <QWidget>

class QAction;
class QObject;
class QWidget;

/// Keyboard access to the whole window, including later additions: a mnemonic for every menu entry,
/// shortcuts named in tool tips, a key that cycles through the panels.
namespace sparkout {

/// Gives every entry its own letter: the letter marked with & if it is free, otherwise the first
/// free one.
void assignMnemonics(const QList<QAction*>& entries);

/// Does so for the menu bar of a window and, whenever they open, for its menus.
void keepMnemonics(QWidget& window);

/// Adds the shortcut to the tooltip of an action; or of every action below an object.
void nameShortcut(QAction& action);
void nameShortcuts(QObject& owner);

/// The mnemonic of a text, in upper case; null if it has none.
[[nodiscard]] QChar mnemonicOf(const QString& text);

/// Moves the focus to the next (1) or previous (-1) visible panel: to its last focused widget, or
/// the first that accepts focus.
void movePanel(const QList<QWidget*>& panels, int by);

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
