// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: own_language
// Torn-off views, the layout that is remembered, and what becomes of a damaged one.
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/kit/sealed_state.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QRandomGenerator>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout::test_layout {

/// A view that shows nothing but its name.
class PlainView : public View {
public:
    explicit PlainView(const QString& name) {
        setObjectName(name);
        auto* layout = new QVBoxLayout(this);
        layout->addWidget(new QLabel(name));
    }
    QString title() const override { return objectName().toUpper(); }
    void showOutcome() override {}
    void retranslate() override {}
    QString hint() const override { return {}; }
};

struct Tabs {
    Tabs() {
        for (const char* name : {"one", "two", "three"}) {
            views.push_back(new PlainView(QString::fromUtf8(name)));
            tabs->addView(views.back());
        }
        tabs->retranslate();
        window.resize(600, 400);
        window.setCentralWidget(tabs);
        window.show();
    }
    [[nodiscard]] QStringList titles() const {
        QStringList list;
        for (int i = 0; i < tabs->count(); ++i) {
            list += tabs->tabText(i);
        }
        return list;
    }
    QMainWindow window;
    ViewTabs* tabs = new ViewTabs(&window);
    std::vector<PlainView*> views;
};

const QStringList allTitles{QStringLiteral("ONE"), QStringLiteral("TWO"), QStringLiteral("THREE")};

std::vector<QDockWidget*> docksOf(const Bench& bench) {
    const auto found = bench.window->findChildren<QDockWidget*>();
    return {found.begin(), found.end()};
}

/// What a person sees of the layout: which panels are where.
QStringList layoutOf(const Bench& bench) {
    QStringList list;
    for (const QDockWidget* dock : docksOf(bench)) {
        list += QStringLiteral("%1 %2 %3 area %4, %5×%6")
                    .arg(dock->objectName())
                    .arg(dock->isVisible())
                    .arg(dock->isFloating())
                    .arg(bench.window->dockWidgetArea(const_cast<QDockWidget*>(dock)))
                    .arg(dock->width())
                    .arg(dock->height());
    }
    return list;
}

void verifyUsable(const Bench& bench) {
    const QWidget* middle = bench.window->centralWidget();
    QVERIFY(middle->isVisible());
    QVERIFY(middle->width() >= 300 && middle->height() >= 200);
    for (const QDockWidget* dock : docksOf(bench)) {
        QVERIFY(!dock->isVisible() || dock->isFloating()
                || bench.window->rect().contains(dock->geometry()));
    }
}

class TestLayout : public QObject {
    Q_OBJECT

private slots:
    void aDoubleClickOnATabTearsItOffAndClosingBringsItBack() {
        Tabs t;
        const QRect tab = t.tabs->tabBar()->tabRect(1);
        QTest::mouseDClick(t.tabs->tabBar(), Qt::LeftButton, {}, tab.center());
        QCOMPARE(t.titles(), QStringList({allTitles[0], allTitles[2]}));
        QWidget* own = t.tabs->windowOf(t.views[1]);
        QVERIFY(own && own->isWindow() && own->isVisible());
        QVERIFY(t.views[1]->isVisible());
        QVERIFY(own->windowTitle().contains(allTitles[1]));
        QVERIFY(own->close());
        QCOMPARE(t.titles(), allTitles); // to its own place
        QCOMPARE(t.tabs->currentWidget(), t.views[1]);
        QVERIFY(t.views[1]->isVisible());
    }

    void theButtonTearsOffTheCurrentViewAndTheLastOneStays() {
        Tabs t;
        auto* button = t.tabs->findChild<QToolButton*>(QStringLiteral("tear"));
        QVERIFY(!button->accessibleName().isEmpty() && !button->toolTip().isEmpty());
        t.tabs->setCurrentIndex(2);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(t.tabs->isDetached(t.views[2]));
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(t.tabs->count(), 1);
        QVERIFY(!button->isEnabled());
        t.tabs->detach(qobject_cast<View*>(t.tabs->widget(0)));
        QCOMPARE(t.tabs->count(), 1);
        t.tabs->attachAll();
        QCOMPARE(t.titles(), allTitles);
        QVERIFY(button->isEnabled());
    }

    void theContextMenuOfATabTearsOffThatTab() {
        Tabs t;
        QTabBar* bar = t.tabs->tabBar();
        emit bar->customContextMenuRequested(bar->tabRect(1).center());
        auto* menu = t.tabs->findChild<QMenu*>();
        QVERIFY(menu && menu->isVisible());
        menu->actions().front()->trigger();
        menu->close();
        QVERIFY(t.tabs->isDetached(t.views[1]));
        emit bar->customContextMenuRequested(QPoint(-5, -5)); // beside the tabs: no menu, no crash
    }

    void viewsComeBackToTheirPlacesInAnyOrder() {
        for (int seed = 0; seed < 50; ++seed) {
            QRandomGenerator random(static_cast<quint32>(seed));
            Tabs t;
            for (int step = 0; step < 20; ++step) {
                View* view = t.views[random.bounded(3u)];
                t.tabs->isDetached(view) ? t.tabs->attach(view) : t.tabs->detach(view);
                QVERIFY(t.tabs->count() >= 1);
            }
            t.tabs->attachAll();
            QCOMPARE(t.titles(), allTitles);
        }
    }

    void tornOffViewsAndTheCurrentTabAreRemembered() {
        Tabs t;
        t.tabs->detach(t.views[0]);
        t.tabs->windowOf(t.views[0])->setGeometry(120, 130, 420, 310);
        t.tabs->setCurrentWidget(t.views[2]);
        const QByteArray state = t.tabs->saveState();
        Tabs again;
        QVERIFY(again.tabs->restoreState(state));
        QVERIFY(again.tabs->isDetached(again.views[0]));
        QCOMPARE(again.tabs->windowOf(again.views[0])->size(), QSize(420, 310));
        QCOMPARE(again.tabs->currentWidget(), again.views[2]);
        QVERIFY(!again.tabs->restoreState(state.left(state.size() / 2)));
        QVERIFY(!again.tabs->restoreState(QByteArray()));
    }

    void closingTheMainWindowWithATornOffViewIsClean() {
        auto t = std::make_unique<Tabs>();
        t->tabs->detach(t->views[1]);
        const QPointer<QWidget> own = t->tabs->windowOf(t->views[1]);
        const QPointer<QWidget> view = t->views[1];
        t.reset();
        QVERIFY(own.isNull() && view.isNull());
    }

    void shortcutsOfTheMainWindowWorkInATornOffView() {
        QMainWindow window;
        QAction action(&window);
        action.setShortcut(Qt::CTRL | Qt::Key_Z);
        window.addAction(&action);
        int triggered = 0;
        connect(&action, &QAction::triggered, this, [&triggered] { ++triggered; });
        auto* tabs = new ViewTabs(&window);
        auto* one = new PlainView(QStringLiteral("one"));
        tabs->addView(one);
        tabs->addView(new PlainView(QStringLiteral("two")));
        window.setCentralWidget(tabs);
        window.show();
        tabs->detach(one);
        tabs->windowOf(one)->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(tabs->windowOf(one)));
        QCOMPARE(tabs->currentView(), one);
        QTest::keyClick(one, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(triggered, 1);
    }

    void everyViewOfTheWindowCanBeTornOffAndGoesOnShowingOutcomes() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        ViewTabs& tabs = bench.window->viewTabs();
        for (View* view : bench.window->views()) {
            tabs.showView(view);
            if (!tabs.canDetach()) {
                break; // the last one stays
            }
            bench.action("detach")->trigger();
            QVERIFY(tabs.isDetached(view));
            QVERIFY(bench.open(examplePaths().back()));
            QVERIFY(view->isVisible());
            bench.action("english")->trigger();
            bench.settle();
            QVERIFY(tabs.windowOf(view)->windowTitle().contains(view->title()));
            bench.action("resetLayout")->trigger();
            QVERIFY(!tabs.isDetached(view));
        }
    }

    // --- the layout -----------------------------------------------------------------------------

    void theLayoutIsRememberedAndCanBeReset() {
        Bench bench(QStringLiteral("en"));
        const QStringList usual = layoutOf(bench);
        bench.dock("inputs").close();
        bench.window->addDockWidget(Qt::LeftDockWidgetArea, &bench.dock("verdict"));
        bench.settle();
        const QStringList changed = layoutOf(bench);
        QVERIFY(changed != usual);
        QVERIFY(bench.window->close());
        MainWindow again(bench.settings, bench.language);
        again.show();
        QTest::qWait(20);
        QVERIFY(!again.findChild<QDockWidget*>(QStringLiteral("inputs"))->isVisible());
        QCOMPARE(again.dockWidgetArea(again.findChild<QDockWidget*>(QStringLiteral("verdict"))),
                 Qt::LeftDockWidgetArea);
        again.findChild<QAction*>(QStringLiteral("resetLayout"))->trigger();
        QTest::qWait(20);
        QVERIFY(again.findChild<QDockWidget*>(QStringLiteral("inputs"))->isVisible());
        QCOMPARE(again.dockWidgetArea(again.findChild<QDockWidget*>(QStringLiteral("verdict"))),
                 Qt::RightDockWidgetArea);
    }

    void aLanguageSwitchLeavesTheLayoutAsItIs() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QDockWidget& verdict = bench.dock("verdict");
        QDockWidget& messages = bench.dock("messages");
        messages.show(); // nothing is said: it was closed
        bench.settle();
        bench.drag({verdict.x() - 2, verdict.y() + verdict.height() / 2}, {-53, 0});
        bench.drag({messages.x() + messages.width() / 2, messages.y() - 2}, {0, -54});
        const int width = verdict.width(), height = messages.height();
        QVERIFY(width > 340 && height > 110);
        const QStringList before = layoutOf(bench);
        const QSize size = bench.window->size();
        for (const char* language : {"russian", "english", "russian"}) {
            bench.action(language)->trigger();
            bench.settle();
            QCOMPARE(layoutOf(bench), before);
            QCOMPARE(bench.window->size(), size);
        }
        QVERIFY(bench.window->close());
        Bench fresh(QStringLiteral("en")); // another window with the settings of the first
        fresh.settings.setWindow(bench.settings.windowGeometry(), bench.settings.windowState());
        fresh.language.apply(QStringLiteral("en"));
        MainWindow again(fresh.settings, fresh.language);
        again.resize(size);
        again.show();
        QTest::qWait(20);
        QCOMPARE(again.findChild<QDockWidget*>(QStringLiteral("verdict"))->width(), width);
        auto* shown = again.findChild<QDockWidget*>(QStringLiteral("messages"));
        shown->show();
        QTest::qWait(20);
        QCOMPARE(shown->height(), height);
    }

    // What presses the panels, and back: a view with much to choose, a narrow window, large type.
    void pressedPanelsTakeTheirRoomBack_data() {
        addColumns<QString, QString>("language", "by");
        for (const char* language : {"en", "ru"}) {
            for (const char* by : {"scatter", "narrow", "type"}) {
                QTest::addRow("%s %s", language, by)
                    << QString::fromUtf8(language) << QString::fromUtf8(by);
            }
        }
    }

    void pressedPanelsTakeTheirRoomBack() {
        QFETCH(QString, language);
        QFETCH(QString, by);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        const auto widths = [&bench] {
            return std::pair(bench.dock("inputs").width(), bench.dock("verdict").width());
        };
        bench.rest();
        const auto before = widths();
        QVERIFY(before.second > 300);
        if (by == u"scatter") {
            QVERIFY(bench.window->showView(QStringLiteral("batch")));
            auto* content = bench.window->findChild<QComboBox*>(QStringLiteral("batchContent"));
            QTRY_VERIFY_WITH_TIMEOUT(content->isEnabled(), 30'000);
            content->setFocus();
            QTest::keyClick(content, Qt::Key_Down);
            QTest::keyClick(content, Qt::Key_Down); // Scatter
            bench.rest();
            QCOMPARE(content->currentIndex(), 2);
            QCOMPARE(widths(), before); // its tools go on in a further line
            content->setCurrentIndex(0);
        } else if (by == u"narrow") {
            bench.resize(1024, 768);
            bench.resize(1366, 768);
        } else {
            bench.setFontSize(130);
            bench.setFontSize(100);
        }
        bench.rest();
        QCOMPARE(widths(), before);
    }

    void aPanelThatTheUserMadeNarrowStaysSo() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QDockWidget& verdict = bench.dock("verdict");
        const int before = verdict.width();
        const QPoint separator(verdict.x() - 2, verdict.y() + verdict.height() / 2);
        bench.drag(separator, {-80, 0});
        const int dragged = verdict.width();
        QVERIFY(dragged > before + 60);
        bench.drag(separator - QPoint(80, 0), {40, 0});
        const int narrower = verdict.width();
        QVERIFY(narrower < dragged - 20);
        bench.resize(1100, 768);
        bench.resize(1366, 768);
        QCOMPARE(verdict.width(), narrower);
    }

    // Closed while a narrow window presses them; opened again where there is room.
    void aLayoutThatWasPressedWhenItWasSavedComesBackAsItWasWanted() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        const auto verdictOf = [](const MainWindow& window) {
            return window.findChild<QDockWidget*>(QStringLiteral("verdict"))->width();
        };
        const int before = verdictOf(*bench.window);
        bench.resize(960, 700);
        QVERIFY(verdictOf(*bench.window) < before - 20);
        QVERIFY(bench.window->close());
        MainWindow again(bench.settings, bench.language);
        again.resize(1366, 768);
        again.show();
        QTRY_COMPARE(verdictOf(again), before);
    }

    void whatOneDragsSaysNothingOfAnotherPanelThatIsPressed() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QDockWidget &verdict = bench.dock("verdict"), &inputs = bench.dock("inputs");
        const auto edge = [&inputs] {
            return QPoint(inputs.geometry().right() + 3, inputs.y() + inputs.height() / 2);
        };
        bench.drag(edge(), {90, 0});
        const int wanted = verdict.width();
        bench.resize(1024, 768);
        QVERIFY2(verdict.width() < wanted - 20, "the window is to press it");
        const int before = inputs.width();
        bench.drag(edge(), {-12, 0});
        QVERIFY(inputs.width() < before);
        bench.resize(1366, 768);
        QCOMPARE(verdict.width(), wanted);
    }

    void aWideWindowHasRoomForTheNamesOfTheVerdict_data() { addLongerLanguages(); }
    void aWideWindowHasRoomForTheNamesOfTheVerdict() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        MainWindow& window = *bench.window;
        const auto* inputs = window.findChild<InputsPanel*>();
        const auto* verdict = window.findChild<QDockWidget*>(QStringLiteral("verdict"));
        const auto* table = verdict->findChild<QTableView*>(QStringLiteral("requirements"));
        const int narrowInputs = inputs->width(), narrowVerdict = verdict->width();
        for (const char* example : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            QVERIFY(bench.open(examplePath(example)));
            window.resize(1920, 1080);
            QTRY_VERIFY(verdict->width() >= 440);
            QCOMPARE(inputs->width(), narrowInputs);
            QVERIFY(window.findChild<ViewTabs*>()->width() > 1050);
            bench.rest();
            int names = 0;
            const int line = table->rowHeight(0); // the name of a group
            for (int row = 0; row < table->model()->rowCount(); ++row) {
                const QString name = table->model()->index(row, 0).data().toString();
                if (!name.contains(u'\n')) { // else its light is named below
                    ++names;
                    QVERIFY2(table->rowHeight(row) < 1.5 * line, qPrintable(name));
                }
            }
            QVERIFY(names > 10);
            window.resize(1366, 768);
            QTRY_COMPARE(verdict->width(), narrowVerdict);
            QCOMPARE(inputs->width(), narrowInputs);
        }
    }

    void theInputsOfAWideWindowAreAsWideAsOneDragsThem() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        MainWindow& window = *bench.window;
        auto* inputs = window.findChild<InputsPanel*>();
        const int before = inputs->width();
        window.resize(1920, 1080);
        QTest::qWait(100);
        const QPoint edge(inputs->mapTo(&window, QPoint(inputs->width() + 2, 300)));
        bench.drag(edge, {140, 0});
        QTRY_VERIFY(inputs->width() > before + 100);
        QTest::qWait(100);
        const int dragged = inputs->width();
        window.resize(1366, 1080);
        QTest::qWait(100);
        window.resize(1920, 1080);
        QTest::qWait(100);
        QCOMPARE(inputs->width(), dragged);
        QVERIFY(window.close());
        MainWindow again(bench.settings, bench.language);
        again.resize(1920, 1080);
        again.show();
        QTRY_COMPARE(again.findChild<InputsPanel*>()->width(), dragged);
    }

    // Large type widens the panels, and the views keep what they have in a small window.
    void theViewsOfAWideWindowKeepTheirRoomInLargeType() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        MainWindow& window = *bench.window;
        auto* inputs = window.findChild<InputsPanel*>();
        const auto* verdict = window.findChild<QDockWidget*>(QStringLiteral("verdict"));
        window.resize(1920, 1080);
        for (const int percent : {90, 115, 130}) {
            bench.setFontSize(percent);
            QTRY_VERIFY(verdict->width() >= atFontSize(450) - 1);
            QVERIFY(window.findChild<ViewTabs*>()->width() >= 690); // and the lines that part them
            for (std::size_t page = 0; page < inputs->pages().size(); ++page) {
                inputs->showPage(static_cast<int>(page));
                QTRY_COMPARE(inputs->pages()[page]->horizontalScrollBar()->maximum(), 0);
            }
        }
    }

    void aThemeSwitchLeavesTheLayoutAsItIs() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QStringList before = layoutOf(bench);
        for (const char* theme : {"theme-dark", "theme-contrast", "theme-light"}) {
            bench.action(theme)->trigger();
            bench.settle();
            QCOMPARE(layoutOf(bench), before);
        }
    }

    void aDamagedLayoutGivesTheUsualOne() {
        Bench bench(QStringLiteral("en"));
        bench.window->findChild<QDockWidget*>(QStringLiteral("verdict"))->close();
        QVERIFY(bench.window->close());
        const QByteArray geometry = bench.settings.windowGeometry();
        const QByteArray state = bench.settings.windowState();
        QVERIFY(unsealed(geometry, 1) && unsealed(state, 3));
        QRandomGenerator random(7);
        for (int round = 0; round < 12; ++round) {
            QByteArray broken[] = {geometry, state};
            for (QByteArray& bytes : broken) {
                if (round % 3 == 0) {
                    bytes.truncate(random.bounded(int(bytes.size())));
                } else if (round % 3 == 1) {
                    const int at = random.bounded(int(bytes.size()));
                    bytes[at] = char(bytes[at] ^ (1 << random.bounded(8)));
                } else {
                    bytes = QByteArray(random.bounded(200), char(random.bounded(256)));
                }
            }
            bench.settings.setWindow(broken[0], broken[1]);
            Bench fresh(QStringLiteral("en"));
            fresh.settings.setWindow(broken[0], broken[1]);
            fresh.window = std::make_unique<MainWindow>(fresh.settings, fresh.language);
            fresh.window->show();
            fresh.settle();
            verifyUsable(fresh);
            QVERIFY(fresh.window->findChild<QDockWidget*>(QStringLiteral("verdict"))->isVisible());
        }
    }

    void sealedPartsComeBackAndDamageIsSeen() {
        const QList<QByteArray> parts{"one", QByteArray(), QByteArray(1000, 'x')};
        const QByteArray bytes = sealed(parts);
        QCOMPARE(unsealed(bytes, 3), std::optional(parts));
        QVERIFY(!unsealed(bytes, 2));
        QVERIFY(!unsealed(QByteArray(), 1));
        for (qsizetype i = 0; i < bytes.size(); ++i) {
            QByteArray flipped = bytes;
            flipped[i] = char(flipped[i] ^ 4);
            QVERIFY(!unsealed(flipped, 3));
            QVERIFY(!unsealed(bytes.left(i), 3));
        }
    }
};

} // namespace sparkout::test_layout

SPARKOUT_TEST(test_layout, TestLayout)
#include "test_layout.moc"
