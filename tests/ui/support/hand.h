// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keyboard as a user has them: what is clicked is in sight, what is typed goes where the
// focus is; and each is counted.
#pragma once

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTest>
#include <QWheelEvent>

namespace sparkout {

class Hand {
public:
    [[nodiscard]] int clicks() const { return m_clicks; } ///< a double click is two
    [[nodiscard]] int keys() const { return m_keys; }
    [[nodiscard]] int turns() const { return m_turns; } ///< of the mouse wheel
    [[nodiscard]] QString faults() const { return m_faults.join(u'\n'); }

    /// The time a practised person takes for it, by the keystroke-level model: to point 1.1 s, to
    /// press a button 0.2 s, a key 0.28 s, and to think 1.35 s before each click.
    [[nodiscard]] double person_s() const {
        constexpr double click_s = 1.35 + 1.1 + 0.2, key_s = 0.28, turn_s = 0.2;
        return m_clicks * click_s + m_keys * key_s + m_turns * turn_s;
    }

    void click(QWidget* widget) {
        if (check(widget != nullptr, QStringLiteral("nothing to click at"))) {
            bringIntoSight(*widget);
            clickAt(*widget, widget->rect().center());
        }
    }
    void clickAt(QWidget& widget, const QPoint& at) {
        if (isInSight(widget, at)) {
            ++m_clicks;
            QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
        }
    }
    void doubleClickAt(QWidget& widget, const QPoint& at) {
        if (isInSight(widget, at)) {
            m_clicks += 2;
            QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
        }
    }

    /// An entry of the menus: a click on the bar, on each submenu and on the entry.
    void choose(QMenuBar& bar, QAction* entry) {
        const QList<QMenu*> way = wayTo(bar, entry);
        if (!check(!way.isEmpty(), QStringLiteral("no such entry: ") + nameOf(entry))) {
            return;
        }
        clickAt(bar, bar.actionGeometry(way.front()->menuAction()).center());
        for (qsizetype i = 0; i < way.size(); ++i) {
            QMenu& menu = *way[i];
            QAction* const next = i + 1 < way.size() ? way[i + 1]->menuAction() : entry;
            if (!check(QTest::qWaitFor([&menu] { return menu.isVisible(); }),
                       QStringLiteral("the menu does not open: ") + menu.title())
                || !check(next->isEnabled(), QStringLiteral("not enabled: ") + nameOf(next))) {
                return;
            }
            clickAt(menu, menu.actionGeometry(next).center());
        }
    }

    /// Where the focus is.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        if (QWidget* const focus = focused()) {
            ++m_keys;
            QTest::keyClick(focus, key, modifiers);
        }
    }
    void type(const QString& text) {
        for (const QChar letter : text) {
            if (QWidget* const focus = focused()) {
                ++m_keys;
                QTest::sendKeyEvent(QTest::Click, focus, Qt::Key(letter.toUpper().unicode()),
                                    QString(letter), Qt::NoModifier);
            }
        }
    }
    void countKey() { ++m_keys; } ///< one that is pressed elsewhere
    /// Goes on, or with Shift back, from field to field to one by its name.
    void tabTo(const QString& name, Qt::KeyboardModifiers modifiers = {}) {
        constexpr int most = 12;
        for (int i = 0; i < most; ++i) {
            const QWidget* const focus = focused();
            if (!focus || focus->objectName() == name) {
                return;
            }
            key(Qt::Key_Tab, modifiers);
        }
        check(false, QStringLiteral("the key Tab does not lead to ") + name);
    }

    bool check(bool holds, const QString& fault) {
        if (!holds && !m_faults.contains(fault)) {
            m_faults += fault;
        }
        return holds;
    }

private:
    static QString nameOf(const QAction* entry) {
        return entry ? entry->objectName() + u' ' + entry->text() : QString();
    }

    /// The menus that lead to an entry, from that of the bar on.
    static QList<QMenu*> wayTo(const QWidget& from, const QAction* entry) {
        for (QAction* const action : from.actions()) {
            QMenu* const menu = action->menu();
            if (!menu) {
                continue;
            }
            if (menu->actions().contains(entry)) {
                return {menu};
            }
            if (QList<QMenu*> further = wayTo(*menu, entry); !further.isEmpty()) {
                further.prepend(menu);
                return further;
            }
        }
        return {};
    }

    QWidget* focused() {
        QWidget* const focus = QApplication::focusWidget();
        check(focus != nullptr, QStringLiteral("nothing has the focus"));
        return focus;
    }

    /// Turns the wheel where the widget is scrolled.
    void bringIntoSight(QWidget& widget) {
        QScrollArea* area = nullptr;
        for (QWidget* one = widget.parentWidget(); one && !area; one = one->parentWidget()) {
            area = qobject_cast<QScrollArea*>(one);
        }
        if (!area) {
            return;
        }
        constexpr int most = 60, notch = 120;
        for (int i = 0; i < most; ++i) {
            QWidget& port = *area->viewport();
            const int top = widget.mapTo(&port, QPoint(0, 0)).y();
            const bool isAbove = top<0, isBelow = top + widget.height()> port.height();
            if (!isAbove && !isBelow) {
                return;
            }
            const QPoint at = port.rect().center();
            QWheelEvent turn(at, port.mapToGlobal(at), {}, QPoint(0, isAbove ? notch : -notch),
                             Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            ++m_turns;
            QApplication::sendEvent(&port, &turn);
        }
    }

    /// Nothing else is in front of it.
    bool isInSight(QWidget& widget, const QPoint& at) {
        const QString name = QStringLiteral("%1 %2").arg(
            QString::fromLatin1(widget.metaObject()->className()), widget.objectName());
        if (!check(widget.isVisible() && widget.isEnabled(),
                   QStringLiteral("not to be clicked: ") + name)) {
            return false;
        }
        QWidget& window = *widget.window();
        const QWidget* const there = window.childAt(widget.mapTo(&window, at));
        return check(&widget == &window || there == &widget
                         || (there && widget.isAncestorOf(there)),
                     QStringLiteral("not in sight: ") + name);
    }

    int m_clicks = 0, m_keys = 0, m_turns = 0;
    QStringList m_faults;
};

} // namespace sparkout
