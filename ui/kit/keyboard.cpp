// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/keyboard.h"

#include "ui/kit/focus_frame.h"

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QWidget>

namespace sparkout {

namespace {

constexpr const char* tipProperty = "sparkoutTip"; ///< the tooltip nameShortcut() made

/// A text without its mnemonic; literal ampersands stay doubled.
QString withoutMnemonic(QString text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != u'&') {
            continue;
        }
        if (text[i + 1] == u'&') {
            ++i;
        } else {
            text.remove(i, 1);
        }
    }
    return text;
}

/// The possible places of a mnemonic: first letters of words before all others.
QList<qsizetype> places(const QString& text) {
    QList<qsizetype> first;
    QList<qsizetype> other;
    for (qsizetype i = 0; i < text.size() && text[i] != u'\t'; ++i) {
        if (text[i].isLetterOrNumber()) {
            const bool starts = i == 0 || !text[i - 1].isLetterOrNumber();
            (starts ? first : other) += i;
        }
    }
    return first + other;
}

bool takesFocus(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && !widget.focusProxy()
           && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QWidget* firstIn(QWidget& panel) {
    if (takesFocus(panel)) {
        return &panel;
    }
    for (QWidget* widget = panel.nextInFocusChain(); widget != &panel;
         widget = widget->nextInFocusChain()) {
        if (panel.isAncestorOf(widget) && takesFocus(*widget)) {
            return widget;
        }
    }
    return nullptr;
}

} // namespace

QChar mnemonicOf(const QString& text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == u'&') {
            if (text[i + 1] != u'&') {
                return text[i + 1].toUpper();
            }
            ++i;
        }
    }
    return {};
}

void assignMnemonics(const QList<QAction*>& entries) {
    QSet<QChar> taken;
    QList<QAction*> without;
    for (QAction* entry : entries) {
        if (entry->isSeparator() || !entry->isVisible() || entry->text().isEmpty()) {
            continue;
        }
        const QChar wanted = mnemonicOf(entry->text());
        if (wanted.isNull() || taken.contains(wanted)) {
            without += entry;
        } else {
            taken += wanted;
        }
    }
    for (QAction* entry : without) {
        QString text = withoutMnemonic(entry->text());
        for (const qsizetype place : places(text)) {
            if (const QChar letter = text[place].toUpper(); !taken.contains(letter)) {
                taken += letter;
                entry->setText(text.insert(place, u'&'));
                break;
            }
        }
    }
}

void keepMnemonics(QWidget& window) {
    for (const QMenuBar* bar : window.findChildren<QMenuBar*>()) {
        assignMnemonics(bar->actions());
    }
    for (QMenu* menu : window.findChildren<QMenu*>()) {
        QObject::connect(menu, &QMenu::aboutToShow, menu,
                         [menu] { assignMnemonics(menu->actions()); });
    }
}

void nameShortcut(QAction& action) {
    if (action.property(tipProperty).toString() == action.toolTip()) {
        action.setToolTip(QString()); // it then falls back to the translated text
    }
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty() && !action.text().isEmpty()) {
        action.setToolTip(QStringLiteral("%1 (%2)").arg(action.toolTip(), keys));
        action.setProperty(tipProperty, action.toolTip());
    }
}

void nameShortcuts(QObject& owner) {
    for (QAction* action : owner.findChildren<QAction*>()) {
        nameShortcut(*action);
    }
}

void movePanel(const QList<QWidget*>& panels, int by) {
    const QWidget* const focus = QApplication::focusWidget();
    qsizetype at = by > 0 ? -1 : 0;
    for (qsizetype i = 0; i < panels.size(); ++i) {
        if (focus && (panels[i] == focus || panels[i]->isAncestorOf(focus))) {
            at = i;
        }
    }
    for (qsizetype step = 0; step < panels.size(); ++step) {
        at = (at + by + panels.size()) % panels.size();
        QWidget& panel = *panels[at];
        QWidget* target = panel.focusWidget();
        if (!target || !takesFocus(*target) || !panel.isAncestorOf(target)) {
            target = firstIn(panel);
        }
        if (panel.isVisible() && target) {
            panel.window()->activateWindow();
            target->setFocus(by > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            FocusFrame::showRound(*target);
            return;
        }
    }
}

} // namespace sparkout
