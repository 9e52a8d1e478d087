// SPDX-License-Identifier: GPL-3.0-or-later
// The room of the verdict panel: what fits, what scrolls, what stays in sight.
#include "tests/registry.h"
#include "tests/ui/views/requirements/verdict_bench.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QHeaderView>
#include <QScopeGuard>
#include <QScrollBar>
#include <QWheelEvent>

#include <QtTest/qtestspontaneevent.h>

namespace sparkout::test_verdict_room {

using namespace verdict_bench;
using verdict_bench::Bench;

class TestVerdictRoom : public VerdictTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    /// That of the panel in a window of 1366 pixels.
    void threeStagesFitIntoTheUsualWidth_data() {
        QTest::addColumn<QString>("code");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("Russian") << QStringLiteral("ru");
    }

    void threeStagesFitIntoTheUsualWidth() {
        QFETCH(QString, code);
        constexpr int width = 310;
        Language language;
        language.apply(code);
        const auto back = qScopeGuard([] { QLocale::setDefault(QLocale::c()); });
        for (const OutcomePtr& outcome : {run(traverseProject(3)), run(plungeProject(4, 3))}) {
            Bench bench(outcome, {width, 400});
            QVERIFY(bench.area().verticalScrollBar()->isVisible()); // the narrow case
            QCOMPARE(bench.panel.width(), width);
            QVERIFY(!bench.table().horizontalScrollBar()->isVisible());
            QCOMPARE(bench.table().horizontalHeader()->length(), bench.table().viewport()->width());
            checkNothingIsCut(bench);
        }
    }

    void moreStagesScrollSideways() {
        Bench bench(run(plungeProject(4, 9)));
        QCOMPARE(bench.model().columnCount(), 10);
        QScrollBar* bar = bench.table().horizontalScrollBar();
        QVERIFY(bar->isVisible() && bar->maximum() > 0);
        checkNothingIsCut(bench);
        bench.table().setFocus();
        bench.table().setCurrentIndex(bench.model().index(0, 0));
        QTest::keyClick(&bench.table(), Qt::Key_End);
        QVERIFY(bar->value() > 0);
        const QRect last = bench.table().visualRect(bench.model().index(0, 9));
        QVERIFY(bench.table().viewport()->rect().contains(last));
    }

    // 1366×768 leaves the panel some 640 px; lower ones must do as well.
    void timeAndLightStayInSightAndTheEndIsReached_data() {
        addColumns<int, int>("sections", "height");
        QTest::newRow("traverse") << 0 << 400;
        QTest::newRow("plunge, 4 sections") << 4 << 400;
        QTest::newRow("plunge, 20 sections") << 20 << 640;
        QTest::newRow("plunge, 20 sections, low") << 20 << 300;
    }

    void timeAndLightStayInSightAndTheEndIsReached() {
        QFETCH(int, sections);
        QFETCH(int, height);
        Bench bench(sections == 0 ? m_traverse : run(plungeProject(sections)), {320, height});
        QCOMPARE(bench.panel.height(), height); // nothing asks for more
        QScrollBar* bar = bench.area().verticalScrollBar();
        QVERIFY(bar->maximum() > 0);
        for (const int position : {0, bar->maximum() / 2, bar->maximum()}) {
            bar->setValue(position);
            QVERIFY(isInSight(bench.label("time"), bench.panel));
            QVERIFY(isInSight(bench.label("overall"), bench.panel));
        }
        const QWidget& table = bench.table();
        const int end = table.mapTo(bench.area().viewport(), QPoint(0, table.height())).y();
        QVERIFY(end <= bench.area().viewport()->height()); // scrolled down to its last row
        QCOMPARE(bench.requirements().verticalScrollBar()->maximum(), 0);
        QCOMPARE(bench.table().verticalScrollBar()->maximum(), 0);
    }

    void turningTheWheelOverATableScrollsThePanel() {
        Bench bench(m_plunge);
        for (CopyTable* table : {&bench.requirements(), &bench.table()}) {
            bench.area().verticalScrollBar()->setValue(0);
            QWidget* under = table->viewport();
            const QPointF at(20, 20);
            QWheelEvent event(at, under->mapToGlobal(at), {}, {0, -240}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QSpontaneKeyEvent::setSpontaneous(&event); // or it would not go up to the panel
            qApp->notify(under, &event);
            QVERIFY2(bench.area().verticalScrollBar()->value() > 0,
                     qPrintable(table->objectName()));
        }
    }

private:
    /// Every number, mark and name has the room it needs.
    static void checkNothingIsCut(Bench& bench) {
        CopyTable& table = bench.table();
        const QFontMetrics metrics = table.fontMetrics();
        for (int row = 0; row < bench.model().rowCount(); ++row) {
            for (int column = 0; column < bench.model().columnCount(); ++column) {
                const QModelIndex index = bench.model().index(row, column);
                const bool mark = !bench.model()
                                       .table()
                                       .cells[std::size_t(row)][std::size_t(column)]
                                       .remark.isEmpty();
                QVERIFY(metrics.horizontalAdvance(index.data().toString()) + (mark ? 10 : 0)
                        < table.columnWidth(column));
            }
            const QString name =
                bench.model().headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
            QVERIFY(metrics.horizontalAdvance(name) < table.verticalHeader()->width());
            QVERIFY(table.rowHeight(row) >= metrics.height());
        }
    }
};

} // namespace sparkout::test_verdict_room

SPARKOUT_TEST(test_verdict_room, TestVerdictRoom)
#include "test_verdict_room.moc"
