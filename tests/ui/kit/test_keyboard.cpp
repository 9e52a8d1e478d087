// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window by keyboard and by screen reader, in both languages.
#include "core/project/part.h"
#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/kit/keyboard.h"
#include "ui/views/requirements/verdict_panel.h"
#include "ui/window/playback_bar.h"
#include "ui/window/view_tabs.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSet>
#include <QShortcut>
#include <QVBoxLayout>

namespace sparkout::test_keyboard {

/// Entries of a menu as they are when it is open.
QList<QAction*> entriesOf(QMenu& menu) {
    emit menu.aboutToShow();
    QList<QAction*> entries;
    for (QAction* action : menu.actions()) {
        if (!action->isSeparator() && action->isVisible()) {
            entries += action;
        }
    }
    return entries;
}

void verifyMnemonics(const QString& where, const QList<QAction*>& entries) {
    QSet<QChar> taken;
    for (const QAction* entry : entries) {
        const QChar letter = mnemonicOf(entry->text());
        const QString what = where + QStringLiteral(": ") + entry->text();
        QVERIFY2(!letter.isNull(), qPrintable(what));
        QVERIFY2(!taken.contains(letter), qPrintable(what));
        taken += letter;
    }
}

QList<QKeySequence> keysOf(const QObject& object) {
    if (const auto* action = qobject_cast<const QAction*>(&object)) {
        return action->shortcuts();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&object)) {
        return {button->shortcut()};
    }
    if (const auto* shortcut = qobject_cast<const QShortcut*>(&object)) {
        return shortcut->keys();
    }
    return {};
}

/// Whether a shortcut works in the whole window, and not only where it belongs.
bool everywhere(const QObject& object) {
    if (const auto* action = qobject_cast<const QAction*>(&object)) {
        return action->shortcutContext() == Qt::WindowShortcut
               || action->shortcutContext() == Qt::ApplicationShortcut;
    }
    if (const auto* shortcut = qobject_cast<const QShortcut*>(&object)) {
        return shortcut->context() == Qt::WindowShortcut
               || shortcut->context() == Qt::ApplicationShortcut;
    }
    return true;
}

/// All panels: nothing is said, so that the messages are closed, and the playback stands below a
/// view that shows a moment.
void showAllPanels(const Bench& bench) {
    (void)bench.window->showView(QStringLiteral("feeds"));
    bench.window->findChild<QDockWidget*>(QStringLiteral("messages"))->show();
    bench.settle();
}

class TestKeyboard : public QObject {
    Q_OBJECT

private slots:
    void everyMenuEntryHasALetterOfItsOwn_data() { addLanguages(); }

    void everyMenuEntryHasALetterOfItsOwn() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        verifyMnemonics(QStringLiteral("menu bar"),
                        bench.window->findChild<QMenuBar*>()->actions());
        int menus = 0;
        for (QMenu* menu : bench.window->findChild<QMenuBar*>()->findChildren<QMenu*>()) {
            verifyMnemonics(menu->title(), entriesOf(*menu));
            ++menus;
        }
        QVERIFY(menus >= 6);
    }

    void lettersAreGivenOutWithoutDuplicates() {
        QMenu menu;
        const char* const texts[] = {"&Save", "&Send", "Save && go", "Set", "Set", "Set", "42"};
        for (const char* text : texts) {
            menu.addAction(QString::fromUtf8(text));
        }
        assignMnemonics(menu.actions());
        QCOMPARE(menu.actions()[0]->text(), QStringLiteral("&Save"));
        QCOMPARE(menu.actions()[1]->text(), QStringLiteral("S&end"));
        QCOMPARE(menu.actions()[2]->text(), QStringLiteral("Save && &go"));
        verifyMnemonics(QStringLiteral("menu"), menu.actions().mid(0, 4));
        const QStringList before{menu.actions()[1]->text(), menu.actions()[3]->text()};
        assignMnemonics(menu.actions()); // again, as with each opening
        QCOMPARE(QStringList({menu.actions()[1]->text(), menu.actions()[3]->text()}), before);
    }

    void noTwoShortcutsOfTheWindowAreTheSame_data() { addLanguages(); }

    void noTwoShortcutsOfTheWindowAreTheSame() {
        QFETCH(QString, language);
        const Bench bench(language);
        QHash<QKeySequence, const QObject*> owners;
        for (const QObject* object : bench.window->findChildren<QObject*>()) {
            for (const QKeySequence& keys : keysOf(*object)) {
                if (keys.isEmpty() || !everywhere(*object)) {
                    continue;
                }
                const QObject* other = owners.value(keys);
                QVERIFY2(!other, qPrintable(keys.toString() + QStringLiteral(": ") + pathOf(object)
                                            + QStringLiteral(" and ") + pathOf(other)));
                owners.insert(keys, object);
            }
        }
        QVERIFY(owners.size() > 12);
    }

    void tooltipsNameTheShortcut_data() { addLanguages(); }

    void tooltipsNameTheShortcut() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        Project project = bench.window->document().project();
        project.part->diameter_mm += 1;
        bench.window->document().edit(project, {"Input", "Diameter"}); // Undo has another text now
        for (const QObject* object : bench.window->findChildren<QObject*>()) {
            const auto* action = qobject_cast<const QAction*>(object);
            const auto* button = qobject_cast<const QAbstractButton*>(object);
            const QKeySequence keys = keysOf(*object).value(0);
            if ((!action && !button) || keys.isEmpty()) {
                continue;
            }
            const QString tip = action ? action->toolTip() : button->toolTip();
            const QString shown = keys.toString(QKeySequence::NativeText);
            const QString wanted = u'(' + shown + u')';
            QVERIFY2(tip.count(wanted) == 1, qPrintable(pathOf(object) + QStringLiteral(": ") + tip
                                                        + QStringLiteral(" / ") + wanted));
        }
        bench.action("english")->trigger();
        bench.settle();
        QCOMPARE(bench.action("open")->toolTip(), QStringLiteral("Open… (Ctrl+O)"));
    }

    void whatOneCanUseHasAnAccessibleName_data() { addLanguages(); }

    void whatOneCanUseHasAnAccessibleName() {
        QFETCH(QString, language);
        Bench bench(language);
        for (const QString& path : {examplePaths().front(), examplePaths().back()}) {
            QVERIFY(bench.open(path));
            const auto widgets = interactiveWidgets(*bench.window);
            QVERIFY(widgets.size() > 60);
            for (const QWidget* widget : widgets) {
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const QString name = widget->accessibleName().isEmpty() && button
                                         ? button->text()
                                         : widget->accessibleName();
                QVERIFY2(!name.isEmpty(), qPrintable(pathOf(widget)));
            }
        }
    }

    void tabGoesThroughAPageFromTopToBottomAndNeverGetsStuck() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        for (int page = 0; page < static_cast<int>(bench.window->inputs().pages().size()); ++page) {
            bench.window->inputs().showPage(page);
            bench.settle();
            const QWidget* body = bench.window->inputs().pages()[std::size_t(page)]->widget();
            QList<const QWidget*> stops;
            for (QWidget* w = body->nextInFocusChain(); w != body; w = w->nextInFocusChain()) {
                if (body->isAncestorOf(w) && w->isVisible() && w->isEnabled()
                    && (w->focusPolicy() & Qt::TabFocus) && !w->focusProxy()) {
                    stops += w;
                }
            }
            QVERIFY(!stops.isEmpty());
            for (qsizetype i = 1; i < stops.size(); ++i) {
                const QPoint before = stops[i - 1]->mapTo(body, QPoint(0, 0));
                const QPoint here = stops[i]->mapTo(body, QPoint(0, 0));
                const bool sameRow = std::abs(before.y() - here.y()) < 12;
                QVERIFY2(
                    sameRow ? here.x() > before.x() : here.y() > before.y(),
                    qPrintable(pathOf(stops[i - 1]) + QStringLiteral(" then ") + pathOf(stops[i])));
            }
        }
    }

    void tabReachesEveryPanelAndComesBack() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        showAllPanels(bench);
        QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
        bench.window->inputs().showPage(0);
        bench.settle();
        movePanel({&bench.window->inputs()}, 1);
        const QWidget* first = QApplication::focusWidget();
        QVERIFY(first);
        QSet<const QWidget*> panels;
        int steps = 0;
        do {
            const QWidget* focus = QApplication::focusWidget();
            for (const QWidget* panel : std::initializer_list<const QWidget*>{
                     &bench.window->inputs(), &bench.window->viewTabs(),
                     bench.window->findChild<PlaybackBar*>(),
                     bench.window->findChild<VerdictPanel*>(), &bench.window->messages()}) {
                if (panel == focus || panel->isAncestorOf(focus)) {
                    panels += panel;
                }
            }
            const auto* text = qobject_cast<const QLabel*>(focus); // Tab goes from link to link
            qsizetype links = text ? text->text().count(QStringLiteral("<a ")) : 0;
            do {
                QTest::keyClick(bench.window->focusWidget(), Qt::Key_Tab);
            } while (QApplication::focusWidget() == focus && links-- > 0);
            QVERIFY2(QApplication::focusWidget() != focus, qPrintable(pathOf(focus)));
        } while (QApplication::focusWidget() != first && ++steps < 500);
        QVERIFY(steps < 500);
        QCOMPARE(panels.size(), 5);
    }

    void f6GoesRoundThePanelsAndRemembersWhereOneWas() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
        showAllPanels(bench);
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<QWidget*>(QStringLiteral("/part/diameter_mm"));
        field->setFocus();
        const QList<QWidget*> order{&bench.window->inputs(), &bench.window->viewTabs(),
                                    bench.window->findChild<PlaybackBar*>(),
                                    bench.window->findChild<VerdictPanel*>(),
                                    &bench.window->messages()};
        const auto at = [&order] {
            const QWidget* focus = QApplication::focusWidget();
            for (qsizetype i = 0; i < order.size(); ++i) {
                if (order[i] == focus || order[i]->isAncestorOf(focus)) {
                    return i;
                }
            }
            return qsizetype(-1);
        };
        QCOMPARE(at(), 0);
        for (qsizetype i = 1; i <= order.size(); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
            QCOMPARE(at(), i % order.size());
        }
        QCOMPARE(QApplication::focusWidget(), field);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(at(), order.size() - 1);
        bench.window->findChild<QDockWidget*>(QStringLiteral("verdict"))->close();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(at(), 2); // a closed panel is passed over
    }

    void theFocusIsSeenAtEachF6_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << int(Theme::light);
        QTest::newRow("dark") << int(Theme::dark);
        QTest::newRow("high contrast") << int(Theme::contrast);
    }

    /// The frame stands round what has the focus, is drawn there, in a colour that is seen on the
    /// window, and goes with the focus.
    void theFocusIsSeenAtEachF6() {
        QFETCH(int, theme);
        Bench bench(QStringLiteral("en"), Theme(theme));
        QVERIFY(bench.open(examplePaths().front()));
        QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
        MainWindow& window = *bench.window;
        showAllPanels(bench);
        window.inputs().showPage(0);
        window.findChild<QWidget*>(QStringLiteral("/part/diameter_mm"))->setFocus();
        QSet<const QWidget*> seen;
        for (const auto modifier : {Qt::NoModifier, Qt::ShiftModifier}) {
            for (int i = 0; i < 6; ++i) {
                const QImage before = window.grab().toImage();
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, modifier);
                bench.settle();
                const QWidget* const focus = QApplication::focusWidget();
                seen += focus;
                const auto* frame = window.findChild<FocusFrame*>();
                QVERIFY2(frame && frame->isVisible(), focus->metaObject()->className());
                const QRect place(focus->mapTo(&window, QPoint(0, 0)), focus->size());
                QVERIFY(frame->geometry().intersects(place));
                const QImage after = window.grab().toImage();
                const QColor colour = frame->palette().color(QPalette::Link);
                int drawn = 0, changed = 0, all = 0;
                const QRect ring = frame->geometry();
                for (int x = ring.left(); x <= ring.right(); ++x) {
                    for (const int y : {ring.top(), ring.bottom()}) {
                        drawn += after.pixelColor(x, y) == colour;
                        changed += after.pixel(x, y) != before.pixel(x, y);
                        ++all;
                    }
                }
                QCOMPARE(drawn, all);
                QVERIFY2(changed > all / 2, focus->metaObject()->className());
            }
        }
        QVERIFY(seen.size() >= 5);
        auto* field = window.findChild<QWidget*>(QStringLiteral("/part/length_mm"));
        field->setFocus(Qt::MouseFocusReason);
        QVERIFY(!window.findChild<FocusFrame*>()->isVisible());
    }

    /// What stood round a widget that is gone no longer takes the frame away from another one.
    void theFrameLetsGoOfAWidgetThatIsGone() {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* first = new QPushButton; // takes a click for itself
        first->setFocusPolicy(Qt::NoFocus);
        auto* second = new QLineEdit;
        layout->addWidget(first);
        layout->addWidget(second);
        auto* within = new QLineEdit(first);
        within->setGeometry(2, 2, 40, 20);
        window.resize(300, 200);
        window.show();
        FocusFrame::showRound(*within);
        auto* frame = window.findChild<FocusFrame*>();
        QVERIFY(frame->isVisible());
        delete within;
        QVERIFY(!frame->isVisible());
        FocusFrame::showRound(*second);
        QVERIFY(frame->isVisible());
        QTest::mouseClick(first, Qt::LeftButton, {}, first->rect().center());
        QVERIFY(frame->isVisible());
    }

    void controlAndANumberShowAView() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
        const auto& views = bench.window->views();
        for (std::size_t i = views.size(); i-- > 0;) {
            const auto digit = Qt::Key(Qt::Key_0 + (int(i) + 1) % 10); // 1 … 9, 0
            const Qt::KeyboardModifiers with =
                i < 10 ? Qt::ControlModifier : Qt::ControlModifier | Qt::AltModifier;
            QTest::keyClick(bench.window.get(), digit, with);
            QCOMPARE(bench.window->viewTabs().currentView(), views[i]);
            QVERIFY(!views[i]->objectName().isEmpty());
            QVERIFY(bench.window->showView(views[i]->objectName()));
        }
        QVERIFY(!bench.window->showView(QStringLiteral("no such")));
    }
};

} // namespace sparkout::test_keyboard

SPARKOUT_TEST(test_keyboard, TestKeyboard)
#include "test_keyboard.moc"
