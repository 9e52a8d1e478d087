// SPDX-License-Identifier: GPL-3.0-or-later
// The tools on a plot that has nothing of its own: one axis rect, two axes.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"

#include <QClipboard>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

#include <qcustomplot.h>

#include <clocale>

namespace sparkout::test_plot_tools {

using namespace fixtures;

/// A plot of y = x² over 0…10, with its tools.
struct Plain {
    QCustomPlot plot;
    PlotTools* tools;

    Plain() {
        QVector<double> x, y;
        for (int i = 0; i <= 100; ++i) {
            x << i * 0.1;
            y << x.back() * x.back();
        }
        plot.addGraph();
        plot.graph()->setData(x, y, true);
        plot.rescaleAxes();
        plot.resize(500, 400);
        PlotSubject subject;
        subject.heading = [] { return QStringList{QStringLiteral("Parabola")}; };
        subject.table = [] {
            return CsvTable{{QStringLiteral("x"), QStringLiteral("y")}, {{2.0, 4.0}}};
        };
        tools = new PlotTools(plot, subject);
        plot.show();
        QApplication::setActiveWindow(&plot);
        plot.setFocus();
        plot.replot();
    }
    [[nodiscard]] QCPRange x() const { return plot.xAxis->range(); }
    [[nodiscard]] QCPRange y() const { return plot.yAxis->range(); }
    [[nodiscard]] QPointF at(double x, double y) const {
        return {plot.xAxis->coordToPixel(x), plot.yAxis->coordToPixel(y)};
    }
};

bool same(const QCPRange& a, const QCPRange& b) {
    return std::abs(a.lower - b.lower) < 1e-9 && std::abs(a.upper - b.upper) < 1e-9;
}

class TestPlotTools : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
    }

    // --- history --------------------------------------------------------------------------------

    void backAndForwardWalkThroughTheStates() {
        PlotHistory history;
        history.restart({0});
        for (double s : {1.0, 2.0, 3.0}) {
            history.visit({s});
        }
        QCOMPARE(history.back(), PlotHistory::State{2});
        QCOMPARE(history.back(), PlotHistory::State{1});
        QCOMPARE(history.forward(), PlotHistory::State{2});
        history.visit({9}); // what lay ahead is gone
        QVERIFY(!history.canGoForward());
        QCOMPARE(history.back(), PlotHistory::State{2});
        QCOMPARE(history.back(), PlotHistory::State{1});
        QCOMPARE(history.back(), PlotHistory::State{0});
        QVERIFY(!history.canGoBack());
    }

    void aGestureIsOneEntryHoweverManyItsSteps() {
        PlotHistory history;
        history.restart({0});
        for (double s : {1.0, 2.0, 3.0}) {
            history.visit({s}, 7);
        }
        for (double s : {4.0, 5.0}) {
            history.visit({s}, 8);
        }
        QCOMPARE(history.back(), PlotHistory::State{3});
        QCOMPARE(history.back(), PlotHistory::State{0});
        // A gesture that goes on after Back is a new entry: what Back showed stays.
        history.forward();
        history.visit({6}, 7);
        QCOMPARE(history.back(), PlotHistory::State{3});
    }

    void nothingNewIsNoEntryAndTheOldestAreForgotten() {
        PlotHistory history;
        history.restart({0});
        history.visit({0});
        QVERIFY(!history.canGoBack());
        for (int i = 1; i < 500; ++i) {
            history.visit({double(i)});
        }
        QCOMPARE(history.size(), PlotHistory::mostStates);
        int steps = 0;
        while (history.canGoBack()) {
            history.back();
            ++steps;
        }
        QCOMPARE(steps, int(PlotHistory::mostStates) - 1);
    }

    // --- mouse ----------------------------------------------------------------------------------

    void theWheelZoomsAtTheMouse() {
        Plain p;
        const QPointF mouse = p.at(2, 25);
        wheel(&p.plot, mouse, 120);
        QVERIFY(p.x().size() < 9 && p.y().size() < 90);
        QVERIFY(std::abs(p.plot.xAxis->pixelToCoord(mouse.x()) - 2) < 1e-9);
        QVERIFY(std::abs(p.plot.yAxis->pixelToCoord(mouse.y()) - 25) < 1e-9);
        wheel(&p.plot, mouse, -120);
        QVERIFY(same(p.x(), QCPRange(0, 10)) && same(p.y(), QCPRange(0, 100)));
    }

    void overAnAxisTheWheelZoomsThatAxisOnly() {
        Plain p;
        const QRect inside = p.plot.axisRect()->rect();
        wheel(&p.plot, QPointF(inside.center().x(), inside.bottom() + 10), 120);
        QVERIFY(p.x().size() < 9);
        QVERIFY(same(p.y(), QCPRange(0, 100)));
        const QCPRange x = p.x();
        wheel(&p.plot, QPointF(inside.left() - 10, inside.center().y()), 120);
        QVERIFY(same(p.x(), x));
        QVERIFY(p.y().size() < 90);
    }

    void withShiftTheWheelPansSideways() {
        Plain p;
        wheel(&p.plot, p.at(5, 50), -120, Qt::ShiftModifier);
        QVERIFY(same(p.x(), QCPRange(1, 11)));
        QVERIFY(same(p.y(), QCPRange(0, 100)));
    }

    void aDragPansAndOverAnAxisPansThatAxis() {
        Plain p;
        drag(&p.plot, p.at(5, 50).toPoint(), p.at(3, 70).toPoint());
        QVERIFY(std::abs(p.x().lower - 2) < 0.05 && std::abs(p.x().size() - 10) < 1e-9);
        QVERIFY(std::abs(p.y().lower + 20) < 0.5 && std::abs(p.y().size() - 100) < 1e-9);
        const QCPRange y = p.y();
        const QRect inside = p.plot.axisRect()->rect();
        const QPoint on(inside.center().x(), inside.bottom() + 8);
        drag(&p.plot, on, on - QPoint(100, 40));
        QVERIFY(p.x().lower > 3);
        QVERIFY(same(p.y(), y));
    }

    void aDoubleClickFits() {
        Plain p;
        wheel(&p.plot, p.at(2, 25), 480);
        QTest::mouseDClick(&p.plot, Qt::LeftButton, {}, p.plot.axisRect()->rect().center());
        QVERIFY(same(p.x(), QCPRange(0, 10)) && same(p.y(), QCPRange(0, 100)));
    }

    // --- back -----------------------------------------------------------------------------------

    void oneWheelGestureOneDragAndOneRunOfKeysAreOneEntryEach() {
        Plain p;
        QVERIFY(!p.tools->back->isEnabled());
        for (int i = 0; i < 6; ++i) {
            wheel(&p.plot, p.at(5, 50), 120);
        }
        const QCPRange zoomed = p.x();
        drag(&p.plot, {250, 200}, {200, 180});
        const QCPRange dragged = p.x();
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(&p.plot, Qt::Key_Right);
        }
        QVERIFY(p.tools->back->isEnabled());
        QTest::keyClick(&p.plot, Qt::Key_Backspace);
        QVERIFY(same(p.x(), dragged));
        QTest::keyClick(&p.plot, Qt::Key_Left, Qt::AltModifier);
        QVERIFY(same(p.x(), zoomed));
        p.tools->back->trigger();
        QVERIFY(same(p.x(), QCPRange(0, 10)));
        QVERIFY(!p.tools->back->isEnabled());
        QTest::keyClick(&p.plot, Qt::Key_Right, Qt::AltModifier);
        QVERIFY(same(p.x(), zoomed));
    }

    void wheelTurnsWithAPauseBetweenAreTwoEntries() {
        Plain p;
        wheel(&p.plot, p.at(5, 50), 120);
        const QCPRange once = p.x();
        QTest::qWait(800);
        wheel(&p.plot, p.at(5, 50), 120);
        p.tools->back->trigger();
        QVERIFY(same(p.x(), once));
        p.tools->back->trigger();
        QVERIFY(same(p.x(), QCPRange(0, 10)));
    }

    void aClickThatMovesNothingIsNoEntry() {
        Plain p;
        QTest::mouseClick(&p.plot, Qt::LeftButton, {}, p.at(5, 50).toPoint());
        QVERIFY(!p.tools->back->isEnabled());
    }

    // --- keys -----------------------------------------------------------------------------------

    void keysZoomPanAndFit() {
        Plain p;
        QTest::keyClick(&p.plot, Qt::Key_Plus);
        QVERIFY(same(p.x(), QCPRange(1, 9)) && same(p.y(), QCPRange(10, 90)));
        QTest::keyClick(&p.plot, Qt::Key_Minus);
        QVERIFY(same(p.x(), QCPRange(0, 10)));
        QTest::keyClick(&p.plot, Qt::Key_Right);
        QVERIFY(same(p.x(), QCPRange(1, 11)));
        QTest::keyClick(&p.plot, Qt::Key_Up);
        QVERIFY(same(p.y(), QCPRange(10, 110)));
        QTest::keyClick(&p.plot, Qt::Key_Up, Qt::ControlModifier);
        QVERIFY(same(p.y(), QCPRange(20, 100)));
        QVERIFY(same(p.x(), QCPRange(1, 11)));
        QTest::keyClick(&p.plot, Qt::Key_Home);
        QVERIFY(same(p.x(), QCPRange(0, 10)) && same(p.y(), QCPRange(0, 100)));
    }

    void onALogarithmicAxisPanningKeepsTheRatio() {
        Plain p;
        p.plot.xAxis->setScaleType(QCPAxis::stLogarithmic);
        p.plot.xAxis->setRange(1, 100);
        QTest::keyClick(&p.plot, Qt::Key_Right);
        QVERIFY(std::abs(p.x().upper / p.x().lower - 100) < 1e-6);
        QVERIFY(p.x().lower > 1.1);
    }

    // --- copies and menus -----------------------------------------------------------------------

    void numbersHaveATrueMinus() {
        QCustomPlot plot;
        style::setUpAxis(*plot.yAxis);
        plot.yAxis->setRange(-10, 10);
        plot.resize(400, 300);
        plot.replot();
        const QVector<QString> labels = plot.yAxis->tickVectorLabels();
        QVERIFY(labels.contains(QStringLiteral("−5")) && labels.contains(QStringLiteral("5")));
        QCOMPARE(Names::micrometres(-9.604), QStringLiteral("−9.60"));
        QCOMPARE(Names::fixed(-0.0004, 3), QStringLiteral("0.000")); // never −0
    }

    void copiesReachTheClipboard() {
        Plain p;
        QTest::keyClick(&p.plot, Qt::Key_C, Qt::ControlModifier);
        const QImage image = QApplication::clipboard()->image();
        const QSize size = pictureSize({&p.plot, {QStringLiteral("Parabola")}, {}});
        QCOMPARE(image.size(), size * 2);
        QTest::keyClick(&p.plot, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("x\ty\n2\t4\n"));
    }

    void theContextMenuOffersEverything() {
        Plain p;
        QStringList texts;
        QTimer::singleShot(0, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu) {
                for (const QAction* action : menu->actions()) {
                    texts << action->text().remove(u'&');
                }
                menu->close();
            }
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, {200, 150},
                                p.plot.mapToGlobal(QPoint(200, 150)));
        QApplication::sendEvent(&p.plot, &event);
        for (const char* text : {"Show all", "Back", "Forward", "Copy the picture", "Copy the data",
                                 "PNG picture", "SVG drawing…", "PDF drawing…", "CSV table"}) {
            QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
        }
    }

    void theExportButtonIsReachedByKeyboardAndNamed() {
        Plain p;
        const std::unique_ptr<QToolButton> button(p.tools->exportButton(nullptr));
        QCOMPARE(button->accessibleName(), QStringLiteral("Export"));
        QVERIFY(button->focusPolicy() & Qt::TabFocus);
        QVERIFY(!button->icon().isNull());
        QCOMPARE(button->menu()->actions().first(), p.tools->copyPicture);
        p.tools->setEnabled(false);
        QVERIFY(!button->isEnabled() && !p.tools->copyPicture->isEnabled());
    }

    void aPlotWithoutDataOffersNoTable() {
        QCustomPlot plot;
        PlotSubject subject;
        subject.heading = [] { return QStringList{QStringLiteral("Empty")}; };
        PlotTools tools(plot, subject);
        QVERIFY(!tools.copyData->isEnabled() && !tools.csvEnglish->isEnabled());
        QVERIFY(tools.svg->isEnabled());
    }

    void everyTextIsTranslated() {
        Marking marking;
        QApplication::installTranslator(&marking);
        Plain p;
        const std::unique_ptr<QToolButton> button(p.tools->exportButton(nullptr));
        QList<QAction*> actions = p.plot.actions() + button->menu()->actions();
        for (const QAction* menu : button->menu()->actions()) {
            if (menu->menu()) {
                emit menu->menu()->aboutToShow(); // names what it has then
                actions += menu->menu()->actions();
            }
        }
        for (const QAction* action : actions) {
            QVERIFY2(action->isSeparator() || action->text().startsWith(QChar(0x00AB)),
                     qPrintable(action->text()));
        }
        QVERIFY(button->toolTip().startsWith(QChar(0x00AB)));
        QApplication::removeTranslator(&marking);
    }
};

} // namespace sparkout::test_plot_tools

SPARKOUT_TEST(test_plot_tools, TestPlotTools)
#include "test_plot_tools.moc"
