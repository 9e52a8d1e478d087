// SPDX-License-Identifier: GPL-3.0-or-later
// What the views have of the window of a small laptop.
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/views/feeds/feeds_view.h"
#include "ui/window/view_tabs.h"

#include <QDockWidget>
#include <QTest>
#include <QToolButton>
#include <qcustomplot.h>

#include <algorithm>

namespace test_room {

using namespace sparkout;

namespace {

QString example(const char* name) {
    const QStringList all = examplePaths();
    const auto found = std::ranges::find(all, QString::fromLatin1(name), nameOf);
    return found == all.end() ? QString() : *found;
}

void wait(const Bench& bench) {
    bench.settle();
    QTest::qWait(60);
    bench.settle();
}

double shareOfViews(const Bench& bench) {
    const QSize views = bench.window->viewTabs().size(), window = bench.window->size();
    return double(views.width()) * views.height() / (double(window.width()) * window.height());
}

QDockWidget* dock(const Bench& bench, const char* name) {
    return bench.window->findChild<QDockWidget*>(QLatin1StringView(name));
}

void languages() {
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << QStringLiteral("en");
    QTest::newRow("ru") << QStringLiteral("ru");
}

} // namespace

class TestRoom : public QObject {
    Q_OBJECT

private slots:
    void theViewsHaveTheirShareOfTheWindow_data() { languages(); }
    void theViewsHaveTheirShareOfTheWindow() {
        QFETCH(QString, language);
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        wait(bench);
        QCOMPARE(bench.window->size(), QSize(1366, 768));
        QVERIFY(dock(bench, "inputs")->isVisible() && dock(bench, "verdict")->isVisible());
        qInfo("ROOM both panels %.3f", shareOfViews(bench));
        QVERIFY(shareOfViews(bench) >= 0.45);
        for (const char* closed : {"verdict", "inputs"}) {
            dock(bench, closed)->close();
            wait(bench);
            qInfo("ROOM without %s %.3f", closed, shareOfViews(bench));
            QVERIFY(shareOfViews(bench) >= 0.6);
            dock(bench, closed)->show();
            wait(bench);
        }
    }

    void theNinePlotsOfFeedsAreLargeEnough_data() { languages(); }
    void theNinePlotsOfFeedsAreLargeEnough() {
        QFETCH(QString, language);
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        wait(bench);
        const auto* view = bench.window->findChild<FeedsView*>();
        int plots = 0;
        for (const auto* plot : view->findChildren<QCustomPlot*>()) {
            if (plot->isVisible() && plot->axisRectCount() == 9) {
                for (const QCPAxisRect* rect : plot->axisRects()) {
                    qInfo("ROOM plot %d × %d", rect->width(), rect->height());
                    QVERIFY(rect->width() >= 180 && rect->height() >= 95);
                    ++plots;
                }
            }
        }
        QCOMPARE(plots, 9);
    }

    void playbackStandsWhereThereIsAMoment() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        const auto* bar = bench.window->findChild<QWidget*>(QStringLiteral("playback"));
        const auto* place = bench.window->findChild<QWidget*>(QStringLiteral("playPlace"));
        for (const auto& [view, moment] : {std::pair{"feeds", true},
                                           {"profiles", true},
                                           {"layers", true},
                                           {"compliance", false},
                                           {"batch", false},
                                           {"sweep", false},
                                           {"optimise", false}}) {
            QVERIFY(bench.window->showView(QString::fromLatin1(view)));
            wait(bench);
            QVERIFY2(bar->isVisible() == moment && place->isVisible() == moment, view);
        }
        for (View* view : bench.window->views()) {
            if (view->objectName() == u"profiles") {
                bench.window->viewTabs().detach(view); // whatever tab is in front
            }
        }
        wait(bench);
        QVERIFY(bar->isVisible());
    }

    void messagesTakeRoomOnlyWhenSomethingIsSaid() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        wait(bench);
        const QDockWidget* messages = dock(bench, "messages");
        auto* button = bench.window->findChild<QToolButton*>(QStringLiteral("messagesButton"));
        QVERIFY(!messages->isVisible());
        QCOMPARE(button->text(), QStringLiteral("No messages"));
        Document& document = bench.window->document();
        Project project = document.project();
        project.wheel->dullness = 0.4; // unusual
        document.edit(project, {"Edit", "Dullness"});
        QTRY_VERIFY(messages->isVisible());
        QCOMPARE(button->text(), QStringLiteral("1 message"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(!messages->isVisible());
        bench.action("russian")->trigger(); // nothing new is said
        wait(bench);
        QVERIFY(!messages->isVisible());
        QCOMPARE(button->text(), QStringLiteral("1 сообщение"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(messages->isVisible());
        document.undo();
        QTRY_VERIFY(!messages->isVisible());
    }

    void theStepThatMendsIsNoMessageOfItsOwn() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        wait(bench);
        Project project = bench.window->document().project();
        project.cycle->stages.front().stock_mm += 0.01;
        bench.window->document().edit(project, {"Edit", "Stock"});
        auto* button = bench.window->findChild<QToolButton*>(QStringLiteral("messagesButton"));
        QTRY_COMPARE(button->text(), QStringLiteral("1 message"));
        QVERIFY(bench.window->messages().count() > 1); // with the step
    }

    void theVerdictKeepsItsWidthWhateverIsShown() {
        Bench bench(QStringLiteral("ru"));
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        wait(bench);
        const int width = dock(bench, "verdict")->width();
        for (const View* view : bench.window->views()) {
            QVERIFY(bench.window->showView(view->objectName()));
            wait(bench);
            QVERIFY2(dock(bench, "verdict")->width() == width, qPrintable(view->objectName()));
        }
    }
};

} // namespace test_room

SPARKOUT_TEST(test_room, TestRoom)
#include "test_room.moc"
