// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QMenu>

class QMainWindow;
class QToolBar;

namespace sparkout {

class Document;

/// The commands of the window, their menus and the tool bar.
class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QMainWindow& window);

    void addDocks(const QList<QAction*>& toggles); ///< to the View menu
    /// What can be undone, and what it is called; a refused text is undone first.
    void follow(const Document& document, bool refusedText);
    void retranslate();
    void showLanguage(const QString& code);

    QAction* newTraverse;
    QAction* newPlunge;
    QAction* open;
    QAction* examples;
    QAction* save;
    QAction* saveAs;
    QAction* quit;
    QAction* undo;
    QAction* redo;
    QAction* english;
    QAction* russian;
    QAction* resetLayout;
    QAction* about;

private:
    QAction* make(const char16_t* icon, const QKeySequence& keys = {});
    void buildMenus(QMainWindow& window);
    void buildToolBar(QMainWindow& window);

    QMenu* m_file;
    QMenu* m_edit;
    QMenu* m_view;
    QMenu* m_language;
    QMenu* m_help;
    QMenu* m_new;
    QToolBar* m_bar;
};

} // namespace sparkout
