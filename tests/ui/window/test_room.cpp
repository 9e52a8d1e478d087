// SPDX-License-Identifier: GPL-3.0-or-later
// What the views have of the window of a small laptop.
#include "core/project/cycle.h"
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/inputs/forms/stage_table.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/plot/svg_device.h"
#include "ui/views/feeds/feeds_plot.h"
#include "ui/views/feeds/feeds_view.h"
#include "ui/window/view_tabs.h"

#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <qcustomplot.h>

#include <algorithm>
#include <vector>

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

/// The areas of its curves, within the plot.
std::vector<QRect> plotsOf(const FeedsView& view) {
    std::vector<QRect> plots;
    for (const QCPAxisRect* rect : view.plot()->axisRects()) {
        plots.push_back(rect->rect());
    }
    return plots;
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
        const std::vector<QRect> plots = plotsOf(*view);
        for (const QRect& plot : plots) {
            qInfo("ROOM plot %d × %d", plot.width(), plot.height());
            QVERIFY(plot.width() >= 180 && plot.height() >= 95);
        }
        QCOMPARE(plots.size(), 9U);
    }

    /// Where the window is too small for nine of them, they are scrolled.
    void thePlotsOfFeedsAreLegibleInLargeType_data() { languages(); }
    void thePlotsOfFeedsAreLegibleInLargeType() {
        QFETCH(QString, language);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        const auto* view = bench.window->findChild<FeedsView*>();
        const auto* area = view->findChild<QScrollArea*>(QStringLiteral("feedsArea"));
        for (const int percent : {115, 130, 100, 130, 115}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            wait(bench);
            QCOMPARE(bench.window->size(), QSize(1366, 768));
            const std::vector<QRect> plots = plotsOf(*view);
            QCOMPARE(plots.size(), 9U);
            for (const QRect& plot : plots) {
                qInfo("ROOM plot at %d %% %d × %d", percent, plot.width(), plot.height());
                QVERIFY(plot.width() >= 120 && plot.height() >= 80);
                QVERIFY(area->widget()->rect().contains(plot));
            }
            const QSize reached = area->viewport()->size()
                                  + QSize(area->horizontalScrollBar()->maximum(),
                                          area->verticalScrollBar()->maximum());
            QCOMPARE(reached, area->widget()->size());
        }
        bench.action("fontSize-100")->trigger();
        wait(bench);
        QCOMPARE(area->widget()->size(), area->viewport()->size()); // nothing left to scroll
    }

    /// Longer than any hint: the values of a pass with their spread.
    void theValuesUnderThePointerHaveRoomInLargeType_data() { languages(); }
    void theValuesUnderThePointerHaveRoomInLargeType() {
        QFETCH(QString, language);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        auto* view = bench.window->findChild<FeedsView*>();
        const auto* values = view->findChild<QLabel*>(QStringLiteral("feedsValues"));
        for (const int percent : fontSizes) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            wait(bench);
            for (const QRect& plot : plotsOf(*view)) {
                QTest::mouseMove(view->plot(), plot.center() + QPoint(9, 4));
                QTest::mouseMove(view->plot(), plot.center());
                qInfo("ROOM values at %d %%: %d of %d", percent,
                      values->heightForWidth(values->width()), values->height());
                QVERIFY(values->text().size() > 80);
                QVERIFY(values->heightForWidth(values->width()) <= values->height());
            }
        }
    }

    void noCaptionOfFeedsAndProfilesIsCutOff_data() { languages(); }
    void noCaptionOfFeedsAndProfilesIsCutOff() {
        QFETCH(QString, language);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        int captions = 0;
        for (const int percent : {130, 100, 115}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            for (const char* name : {"feeds", "profiles"}) {
                QVERIFY(bench.window->showView(QString::fromLatin1(name)));
                wait(bench);
                for (const auto* plot :
                     bench.window->viewTabs().currentView()->findChildren<QCustomPlot*>()) {
                    for (QCPLayoutElement* element : plot->plotLayout()->elements(true)) {
                        const auto* caption = qobject_cast<QCPTextElement*>(element);
                        if (!caption || !plot->isVisible()) {
                            continue;
                        }
                        const QFontMetrics metrics(caption->font());
                        for (const QString& line : caption->text().split(u'\n')) {
                            ++captions;
                            QVERIFY2(metrics.horizontalAdvance(line) <= caption->rect().width(),
                                     qPrintable(line));
                        }
                    }
                }
            }
        }
        QVERIFY(captions > 30);
    }

    void theNamesOfAxesHaveRoom_data() { languages(); }
    void theNamesOfAxesHaveRoom() {
        QFETCH(QString, language);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        int names = 0;
        for (const int percent : {130, 100}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            for (const char* view : {"feeds", "profiles", "constraints", "compliance", "layers",
                                     "optimise", "compare"}) {
                QVERIFY(bench.window->showView(QString::fromLatin1(view)));
                wait(bench);
                for (const auto* plot :
                     bench.window->viewTabs().currentView()->findChildren<QCustomPlot*>()) {
                    for (const QCPAxisRect* rect : plot->axisRects()) {
                        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
                        if (!plot->isVisible() || !axis || !axis->visible()) {
                            continue;
                        }
                        const int middle = rect->center().x();
                        const int room = 2 * std::min(middle, plot->width() - middle);
                        for (const QString& line : axis->label().split(u'\n')) {
                            names += line.isEmpty() ? 0 : 1;
                            const int wide =
                                QFontMetrics(axis->labelFont()).horizontalAdvance(line);
                            QVERIFY2(wide <= room,
                                     qPrintable(QString::fromLatin1(view) + u' ' + line));
                        }
                    }
                }
            }
        }
        QVERIFY2(names >= 12, qPrintable(QString::number(names)));
    }

    /// Beside or below its mark, in whatever type.
    void aLongFeedWithAWarningIsReadInFull_data() { languages(); }
    void aLongFeedWithAWarningIsReadInFull() {
        QFETCH(QString, language);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(language);
        QVERIFY(bench.open(example("shaft-30h6-factory")));
        Document& document = bench.window->document();
        Project project = document.project();
        project.cycle->stages.front().axial_feed_mm_min = 12500;
        document.edit(project, {"Edit", "Axial feed"});
        bench.window->findChild<InputsPanel*>()->showCycle();
        const auto* view = bench.window->findChild<StageTable*>()->findChild<QTableView*>();
        for (const int percent : fontSizes) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            wait(bench);
            const QModelIndex cell = view->model()->index(0, 1);
            QVERIFY(view->isVisible() && !cell.data(Qt::DecorationRole).isNull());
            const QString text = cell.data(Qt::DisplayRole).toString();
            QVERIFY(text.endsWith(u"500"));
            SvgDevice device(view->viewport()->size(), 96, {});
            QPainter painter(&device);
            view->viewport()->render(&painter);
            painter.end();
            const QString drawn = QString::fromUtf8(device.document());
            QVERIFY2(drawn.contains(u'>' + text + u'<'), qPrintable(QString::number(percent)));
            QVERIFY(!drawn.contains(u'…'));
        }
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
