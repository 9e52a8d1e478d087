// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// What the stage table shows: its columns, times and shares, the copy of it.
#include "core/study/evaluate.h"
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "tests/whole_project.h"
#include "ui/inputs/forms/stage_model.h"

#include <QApplication>
#include <QClipboard>
#include <QLocale>
#include <QScrollBar>

#include <cmath>
#include <initializer_list>

namespace sparkout::test_stage_table_shown {

using namespace stage_table_bench;
using stage_table_bench::Bench;

QStringList words(std::initializer_list<const char*> texts) {
    QStringList list;
    for (const char* text : texts) {
        list += QString::fromUtf8(text);
    }
    return list;
}

QStringList heads(const QTableView& view) {
    QStringList list;
    for (int column = 0; column < view.model()->columnCount(); ++column) {
        list += view.model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    }
    return list;
}

class TestStageTableShown : public QObject {
    Q_OBJECT

private slots:
    void aPlungeCycleShowsItsOwnColumns() {
        Bench bench(Operation::plunge);
        QCOMPARE(heads(bench.table.view()),
                 words({"Radial feed, mm/min", "Stock per side, mm", "Spark-out", "Time, s"}));
        bench.select(0, 0);
        auto* editor = bench.openEditor();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0.8"));
        QCOMPARE(bench.stages()[0].radial_feed_mm_min.value(), 0.8);
    }

    void aTraverseCycleShowsItsOwnColumnsWithTheStockPerSide() {
        Bench bench;
        QCOMPARE(heads(bench.table.view()),
                 words({"Radial feed, mm/dbl stroke", "Axial feed, mm/min", "Stock per side, mm",
                        "Spark-out", "Time, s"}));
    }

    void aLongStageHasItsTimeWithoutAnExponent() {
        Bench bench;
        Project slow = bench.document.project();
        slow.cycle->stages[1].axial_feed_mm_min = 20;
        bench.table.setOutcome(evaluate(slow, {}));
        const QAbstractItemModel& model = *bench.table.view().model();
        const QString time = model.index(1, model.columnCount() - 1).data().toString();
        QVERIFY2(QLocale().toDouble(time) > 1000 && !time.contains(u'E', Qt::CaseInsensitive),
                 qPrintable(time));
    }

    void copyPutsTheTableOnTheClipboardForASpreadsheet() {
        Bench bench;
        bench.table.setOutcome(evaluate(bench.document.project(), {}));
        QTest::keyClick(&bench.table.view(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines =
            QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines[0].split(u'\t'),
                 words({"Stage", "Radial feed, mm/dbl stroke", "Axial feed, mm/min",
                        "Stock per side, mm", "Spark-out", "Time, s"}));
        const QStringList first = lines[1].split(u'\t');
        QCOMPARE(first.mid(0, 5),
                 QStringList({QStringLiteral("1"), QLocale().toString(0.004),
                              QStringLiteral("1800"), QLocale().toString(0.11), QString()}));
        QVERIFY(QLocale().toDouble(first[5]) > 0);
        QCOMPARE(lines[2].split(u'\t')[4], QStringLiteral("none"));
    }

    void eachStageShowsItsShareOfTimeAndOfStock() {
        Bench bench;
        QAbstractItemModel& model = *bench.table.view().model();
        const auto share = [&model](int row, int column) {
            return model.index(row, column).data(StageModel::shareRole);
        };
        QVERIFY(!share(0, 2).isValid()); // nothing has run
        const OutcomePtr outcome = evaluate(bench.document.project(), {});
        bench.table.setOutcome(outcome);
        QVERIFY(std::abs(share(0, 2).toDouble() - 0.11 / 0.15) < 1e-12);
        QVERIFY(std::abs(share(1, 2).toDouble() - 0.04 / 0.15) < 1e-12);
        QVERIFY(std::abs(share(0, 4).toDouble() + share(1, 4).toDouble() - 1) < 1e-12);
        QCOMPARE(share(1, 4).toDouble(), outcome->result.timeByStage_s[1] / outcome->result.time_s);
        QCOMPARE(model.index(0, 4).data().toDouble(),
                 QLocale().toString(outcome->result.timeByStage_s[0], 'g', 3).toDouble());
        QVERIFY(!share(0, 0).isValid());
        QVERIFY(!(model.flags(model.index(0, 4)) & Qt::ItemIsEditable));
    }

    // The first stage takes what the later ones leave of the part's stock, whatever it states.
    void theStockOfTheFirstStageIsWhatTheOthersLeave() {
        Bench bench;
        Project project = bench.document.project();
        project.cycle->stages[0].stock_mm = 0.05;
        bench.document.startUntitled(project);
        bench.table.setOutcome(evaluate(project, {}));
        QVERIFY(
            std::abs(bench.table.view().model()->index(0, 2).data(StageModel::shareRole).toDouble()
                     - 0.11 / 0.15)
            < 1e-12);
    }

    void sharesOfTheLastGoodRunAreGreyWhileTheInputsAreFaulty() {
        Bench bench;
        QAbstractItemModel& model = *bench.table.view().model();
        bench.table.setOutcome(evaluate(bench.document.project(), {}));
        const QVariant before = model.index(0, 4).data(StageModel::shareRole);
        QVERIFY(!model.index(0, 4).data(StageModel::staleRole).toBool());
        const QImage good = bench.table.view().grab().toImage();
        Project faulty = bench.document.project();
        faulty.part->radii_per_section = 35;
        bench.table.setOutcome(evaluate(faulty, {}));
        QVERIFY(model.index(0, 4).data(StageModel::staleRole).toBool());
        QCOMPARE(model.index(0, 4).data(StageModel::shareRole), before);
        QVERIFY(bench.table.view().grab().toImage() != good);
        bench.select(0, 0);
        QTest::keyClick(&bench.table.view(), Qt::Key_Insert); // other stages: nothing is known
        QVERIFY(!model.index(0, 4).data(StageModel::shareRole).isValid());
    }

    void theWholeTableIsInSightWithoutScrolling() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            Bench bench(operation);
            bench.table.setOutcome(evaluate(bench.document.project(), {}));
            QApplication::processEvents();
            QTableView& view = bench.table.view();
            QCOMPARE(view.horizontalScrollBar()->maximum(), 0);
            QCOMPARE(view.verticalScrollBar()->maximum(), 0);
        }
    }
};

} // namespace sparkout::test_stage_table_shown

SPARKOUT_TEST(test_stage_table_shown, TestStageTableShown)
#include "test_stage_table_shown.moc"
