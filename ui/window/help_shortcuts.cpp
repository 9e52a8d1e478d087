// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_shortcuts.h"

#include "ui/inputs/inputs_panel.h"
#include "ui/plot/view.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <utility>

namespace sparkout {

namespace {

/// Commands with their keys, each pair once.
class KeyTable {
public:
    void add(const QString& command, const QList<QKeySequence>& keys) {
        QStringList shown;
        for (const QKeySequence& key : keys) {
            if (!key.isEmpty()) {
                shown += key.toString(QKeySequence::NativeText);
            }
        }
        const std::pair row{command, shown.join(QStringLiteral(", "))};
        if (!shown.isEmpty() && !command.isEmpty() && !m_rows.contains(row)) {
            m_rows += row;
        }
    }

    void add(const QAction& action) {
        QString text = action.iconText(); // without mnemonic
        add(text.remove(u'…'), action.shortcuts());
    }

    void addMenu(const QMenu& menu) {
        for (const QAction* action : menu.actions()) {
            if (const QMenu* below = action->menu()) {
                addMenu(*below);
            } else {
                add(*action);
            }
        }
    }

    [[nodiscard]] QString html(const QString& title, const char* anchor) const {
        if (m_rows.isEmpty()) {
            return {};
        }
        QString text = QStringLiteral("<h2 id=\"%1\">%2</h2><table>")
                           .arg(QString::fromLatin1(anchor), title.toHtmlEscaped());
        for (const auto& [command, keys] : m_rows) {
            text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                        .arg(keys.toHtmlEscaped(), command.toHtmlEscaped());
        }
        return text + QStringLiteral("</table>");
    }

private:
    QList<std::pair<QString, QString>> m_rows;
};

QString shortcutsTr(const char* text) {
    return QCoreApplication::translate("Help", text);
}

} // namespace

QString shortcutsHtml(const QMainWindow& window) {
    KeyTable menus;
    for (const QAction* top : window.findChild<QMenuBar*>()->actions()) {
        if (const QMenu* menu = top->menu()) {
            menus.addMenu(*menu);
        }
    }
    KeyTable pages;
    if (const auto* panel = window.findChild<InputsPanel*>()) {
        for (const auto* button : panel->findChildren<QAbstractButton*>()) {
            pages.add(button->text(), {button->shortcut()});
        }
    }
    KeyTable plots;
    for (const auto* view : window.findChildren<View*>()) {
        for (const QAction* action : view->findChildren<QAction*>()) {
            plots.add(*action);
        }
    }
    return menus.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "Commands of the menus")), "menus")
           + pages.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "Pages of the inputs")), "pages")
           + plots.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "In a plot")), "plots");
}

} // namespace sparkout
