// SPDX-License-Identifier: GPL-3.0-or-later
// The tour of the window: by keys, beside what it tells of, and only once by itself.
#include "tests/registry.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/help/tour.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/help_desk.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QToolBar>

namespace sparkout::test_tour {

constexpr int steps = 7;

Tour& tourOf(const Bench& bench) {
    return bench.window->help().tour();
}

bool ready(const Bench& bench) {
    return QTest::qWaitForWindowActive(bench.window.get());
}

void press(Qt::Key key) {
    QTest::keyClick(QApplication::focusWidget(), key);
}

class TestTour : public QObject {
    Q_OBJECT

private slots:
    void keysGoThroughAllSteps_data() {
        addColumns<QString, QSize>("language", "size");
        QTest::newRow("en, small") << QStringLiteral("en") << QSize(1366, 768);
        QTest::newRow("ru, small") << QStringLiteral("ru") << QSize(1366, 768);
        QTest::newRow("ru, large") << QStringLiteral("ru") << QSize(1920, 1080);
    }

    void keysGoThroughAllSteps() {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        Bench bench(language);
        bench.window->resize(size);
        QVERIFY(bench.open(examplePaths().front()) && ready(bench));
        bench.action("tour")->trigger();
        QSet<QString> titles;
        QSet<QPoint> places;
        for (int i = 0; i < steps; ++i) {
            bench.settle();
            const TourBalloon* balloon = tourOf(bench).balloon();
            QVERIFY(balloon && balloon->isVisible());
            QCOMPARE(tourOf(bench).step(), i);
            QVERIFY2(bench.window->rect().contains(balloon->body().translated(balloon->pos())),
                     qPrintable(balloon->title()));
            const QStringList cut = textsWithoutRoom(*balloon);
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
            if (language == u"ru") {
                for (const ShownText& shown : textsOf(*balloon)) {
                    QCOMPARE(englishIn(shown.text), QString());
                }
            }
            titles += balloon->title();
            places += balloon->pos();
            press(Qt::Key_Return);
        }
        QVERIFY(!tourOf(bench).running());
        QCOMPARE(titles.size(), steps);
        QVERIFY(places.size() >= steps - 1); // beside each part
    }

    void theFirstStepPointsAtTheButtonItNames_data() {
        addColumns<QString, int>("language", "width");
        for (const char* code : {"en", "ru"}) {
            for (const int width : {1024, 1366, 1920}) {
                QTest::addRow("%s %d", code, width) << QString::fromLatin1(code) << width;
            }
        }
    }

    void theFirstStepPointsAtTheButtonItNames() {
        QFETCH(QString, language);
        QFETCH(int, width);
        Bench bench(language);
        bench.window->resize(width, 768);
        QVERIFY(bench.open(examplePaths().front()) && ready(bench));
        bench.action("tour")->trigger();
        bench.settle();
        const auto* bar = bench.window->findChild<QToolBar*>(QStringLiteral("toolBar"));
        const QWidget* button = bar->widgetForAction(bench.action("examples"));
        QCOMPARE(bar->actions().back(), bench.action("examples")); // "the last button"
        QVERIFY(button->isVisible());
        const QRect place(button->mapTo(bench.window.get(), QPoint(0, 0)), button->size());
        const QPoint tip = tourOf(bench).balloon()->tip();
        QVERIFY2(place.contains(tip),
                 qPrintable(QStringLiteral("%1 %2").arg(tip.x()).arg(tip.y())));
        QVERIFY(!tourOf(bench)
                     .balloon()
                     ->body()
                     .translated(tourOf(bench).balloon()->pos())
                     .intersects(place));
    }

    void backAndEscape() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()) && ready(bench));
        bench.action("tour")->trigger();
        press(Qt::Key_Return);
        press(Qt::Key_Return);
        QCOMPARE(tourOf(bench).step(), 2);
        QTest::keyClick(bench.window->findChild<QWidget*>(QStringLiteral("tourBack")),
                        Qt::Key_Space);
        QCOMPARE(tourOf(bench).step(), 1);
        auto* next = bench.window->findChild<QAbstractButton*>(QStringLiteral("tourNext"));
        press(Qt::Key_Escape);
        QVERIFY(!tourOf(bench).running());
        next->click(); // by a key that came while the balloon went
        QVERIFY(!tourOf(bench).running());
        QTRY_VERIFY(!bench.window->findChild<TourBalloon*>());
        bench.action("tour")->trigger(); // again, from its beginning
        QCOMPARE(tourOf(bench).step(), 0);
        bench.window->findChild<QWidget*>(QStringLiteral("play"))->setFocus();
        press(Qt::Key_Escape); // wherever the focus is
        QVERIFY(!tourOf(bench).running());
    }

    void whatItTellsOfIsBroughtIntoSight() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()) && ready(bench));
        for (const char* name : {"inputs", "verdict"}) {
            bench.window->findChild<QDockWidget*>(QString::fromLatin1(name))->hide();
        }
        bench.action("tour")->trigger();
        for (int i = 0; i < steps; ++i) {
            QCOMPARE(tourOf(bench).step(), i); // none is passed over
            press(Qt::Key_Return);
        }
        for (const char* name : {"inputs", "verdict"}) {
            QVERIFY(bench.window->findChild<QDockWidget*>(QString::fromLatin1(name))->isVisible());
        }
    }

    void itFollowsSizeAndLanguage() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()) && ready(bench));
        bench.action("tour")->trigger();
        for (int i = 0; i < 3; ++i) {
            press(Qt::Key_Return); // the verdict
        }
        const QPoint before = tourOf(bench).balloon()->pos();
        bench.window->resize(1600, 900);
        QTRY_VERIFY(tourOf(bench).balloon()->pos() != before);
        bench.action("russian")->trigger();
        QTRY_COMPARE(tourOf(bench).balloon()->title(), QStringLiteral("Выполнен ли чертёж?"));
    }

    void itComesByItselfOnceAndNeverWithoutSettings() {
        {
            Bench bench(QStringLiteral("en")); // settings that nothing keeps
            bench.window->help().offerTour();
            QVERIFY(!tourOf(bench).running());
        }
        const QTemporaryDir folder;
        Settings settings(folder.filePath(QStringLiteral("settings.json")));
        Language language;
        language.apply(QStringLiteral("en"));
        {
            MainWindow window(settings, language);
            window.show();
            QVERIFY(QTest::qWaitForWindowActive(&window));
            ExamplesDialog question(&window);
            question.open();
            window.help().offerTour(); // not over a question
            QVERIFY(!window.help().tour().running());
            question.close();
            window.help().offerTour();
            QVERIFY(window.help().tour().running());
        }
        MainWindow window(settings, language);
        window.show();
        window.help().offerTour();
        QVERIFY(!window.help().tour().running());
    }
};

} // namespace sparkout::test_tour

SPARKOUT_TEST(test_tour, TestTour)
#include "test_tour.moc"
