// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

class QAction;
class QObject;
class QWidget;

/// What makes the whole window work by keyboard, whatever is added to it: a mnemonic for every
/// entry of every menu, shortcuts named in tooltips, a key that goes round the panels.
namespace sparkout {

/// Gives every entry its own letter: a letter a text asks for with & is kept where it is free, the
/// others get the first free one.
void assignMnemonics(const QList<QAction*>& entries);

/// Does so for the menu bar below a window and, whenever they open, for its menus.
void keepMnemonics(QWidget& window);

/// Adds the shortcut to the tooltip of an action; or of every action below an object.
void nameShortcut(QAction& action);
void nameShortcuts(QObject& owner);

/// The mnemonic a text asks for, in upper case; null when none.
[[nodiscard]] QChar mnemonicOf(const QString& text);

/// Moves the focus to the next (1) or previous (-1) of the panels in sight: to what had it last
/// there, else to the first thing that takes it.
void movePanel(const QList<QWidget*>& panels, int by);

} // namespace sparkout
