// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The stages of the table, added, removed, moved, made to spark out; what it shows of them.
#include "core/project/validate.h"
#include "core/study/outcome.h"
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "tests/ui/support/typing.h"
#include "tests/whole_project.h"
#include "ui/inputs/stage_model.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>

#include <cmath>
#include <initializer_list>
#include <optional>

namespace sparkout::test_stage_table_stages {

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

class TestStageTableStages : public QObject {
    Q_OBJECT

private slots:
    void insertAddsAStageAndControlDeleteRemovesItWithTheSumOfStocksKept() {
        Bench bench;
        const double sum = bench.stockSum();
        bench.select(0, 0);
        QTest::keyClick(&bench.table.view(), Qt::Key_Insert);
        QCOMPARE(bench.stages().size(), 3u);
        QCOMPARE(bench.table.view().currentIndex().row(), 1);
        QVERIFY(std::abs(bench.stockSum() - sum) < 1e-12);
        QVERIFY(!hasErrors(validate(bench.document.project())));
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(bench.stages().size(), 2u);
        QVERIFY(std::abs(bench.stockSum() - sum) < 1e-12);
        bench.document.undo();
        bench.document.undo();
        QCOMPARE(bench.stages().size(), 2u);
        QVERIFY(!bench.document.canUndo());
    }

    void theSparkOutIsAddedAfterTheLastFeedNotInItsPlace() {
        Bench bench;
        auto* const button = bench.table.findChild<QPushButton*>(QStringLiteral("addSparkOut"));
        QVERIFY(button && button->isVisible());
        const std::vector<Stage> before = bench.stages();
        const double sum = bench.stockSum();
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(bench.stages().size(), before.size() + 1);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QVERIFY(bench.stages()[i].feeds());
            QCOMPARE(bench.stages()[i].stock_mm, before[i].stock_mm);
        }
        QVERIFY(!bench.stages().back().feeds() && bench.stages().back().sparkOutSteps() == 2);
        QCOMPARE(bench.stockSum(), sum);
        QVERIFY(!hasErrors(validate(bench.document.project())));
        QVERIFY(!button->isVisible());
        bench.document.undo();
        QCOMPARE(bench.stages().size(), before.size());
        QVERIFY(button->isVisible());
    }

    // The usual table has no column for it.
    void theBoxBelowTheTableAddsAContinuousInfeed() {
        Bench bench;
        auto* const box = bench.table.findChild<QCheckBox*>(QStringLiteral("continuousInfeed"));
        auto* const model = bench.table.view().model();
        const int usual = model->columnCount();
        QVERIFY(box->isVisible() && !box->isChecked());
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        QVERIFY(box->isChecked());
        QCOMPARE(model->columnCount(), usual + 1);
        QCOMPARE(bench.stages()[0].continuous_feed_mm_min, std::optional(0.0));
        QVERIFY(!hasErrors(validate(bench.document.project())));
        int column = 0;
        while (column < usual
               && !model->headerData(column, Qt::Horizontal)
                       .toString()
                       .contains(QLatin1String("Cont."))) {
            ++column;
        }
        bench.select(1, column);
        QTest::keyClicks(bench.openEditor(), QStringLiteral("0.02"));
        QTest::keyClick(bench.openEditor(), Qt::Key_Return);
        QCOMPARE(bench.stages()[1].continuous_feed_mm_min, std::optional(0.02));
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        QCOMPARE(model->columnCount(), usual);
        QVERIFY(!bench.stages()[1].continuous_feed_mm_min);
        bench.document.undo();
        QVERIFY(box->isChecked());
        QCOMPARE(bench.stages()[1].continuous_feed_mm_min, std::optional(0.02));
        bench.document.startUntitled(newProject(Operation::plunge));
        QVERIFY(!box->isVisible());
    }

    void theTableHasRoomForAContinuousInfeedInBothLanguages() {
        Language language;
        for (const char* code : {"en", "ru"}) {
            language.apply(QString::fromLatin1(code));
            Bench bench;
            auto* const box = bench.table.findChild<QCheckBox*>(QStringLiteral("continuousInfeed"));
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
            const QTableView& view = bench.table.view();
            QVERIFY2(view.horizontalHeader()->length() <= view.viewport()->width(),
                     qPrintable(QStringLiteral("%1 of %2")
                                    .arg(view.horizontalHeader()->length())
                                    .arg(view.viewport()->width())));
        }
        language.apply(QStringLiteral("en"));
        QLocale::setDefault(QLocale::c());
    }

    void theLastStageThatIsLeftCannotBeRemoved() {
        Bench bench;
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete, Qt::ControlModifier);
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(bench.stages().size(), 1u);
    }

    void controlArrowsMoveTheStageAndTheSelectionGoesWithIt() {
        Bench bench(1, 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.002);
        QCOMPARE(bench.table.view().currentIndex().row(), 0);
        QCOMPARE(bench.table.view().currentIndex().column(), 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(bench.stages()[1].radial_feed_mm.value(), 0.002);
        QCOMPARE(bench.table.view().currentIndex().row(), 1);
    }

    void theButtonsDoTheSameAsTheKeys() {
        Bench bench(0, 0);
        const auto buttons = bench.table.findChildren<QToolButton*>();
        const auto click = [&buttons](const char* icon) {
            for (QToolButton* button : buttons) {
                if (button->accessibleName() == QLatin1String(icon)) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    return;
                }
            }
            QFAIL(icon);
        };
        click("Add a stage");
        QCOMPARE(bench.stages().size(), 3u);
        click("Move the stage down");
        QCOMPARE(bench.table.view().currentIndex().row(), 2);
        click("Move the stage up");
        click("Remove the stage");
        QCOMPARE(bench.stages().size(), 2u);
    }

    void theMenuKeyOffersTheSameCommands() {
        Bench bench;
        QContextMenuEvent event(QContextMenuEvent::Keyboard, {5, 5},
                                bench.table.view().mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(&bench.table.view(), &event);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        const auto actions = menu->actions();
        actions.first()->trigger();
        menu->close();
        QCOMPARE(bench.stages().size(), 3u);
        actions.constLast()->trigger();
        QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("Stage\t")));
    }

    void aStageCanBeAddedBeforeASparkOut() {
        Bench bench;
        Project project = bench.document.project();
        project.cycle->stages[1].radial_feed_mm.reset();
        project.cycle->stages[1].spark_out = {SparkOut::Mode::count, 4};
        bench.document.startUntitled(project);
        bench.select(1, 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Insert);
        QCOMPARE(bench.stages().size(), 3u);
        QCOMPARE(bench.stages()[2].spark_out.count, 4);
        QVERIFY(!hasErrors(validate(bench.document.project())));
    }

    void theLastStageBecomesASparkOutUntilSizeByKeysAndFeedsNothing() {
        Bench bench(1, 3);
        QTest::keyClick(&bench.table.view(), Qt::Key_F2);
        auto* mode = bench.table.view().findChild<QComboBox*>();
        QVERIFY(mode);
        QTest::keyClick(mode, Qt::Key_Down);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
        QVERIFY(bench.stages()[1].spark_out.count > 0);
        QVERIFY(!bench.stages()[1].radial_feed_mm.has_value());
        QTest::keyClick(mode, Qt::Key_Down);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::untilSize);
        QVERIFY(!hasErrors(validate(bench.document.project())));
        QTest::keyClick(mode, Qt::Key_Up);
        QTest::keyClick(mode, Qt::Key_Up);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::none);
        QVERIFY(bench.stages()[1].radial_feed_mm.has_value());
    }

    void aRefusedCountOfASparkOutStaysInTheCellAsLongAsThereIsSomethingToCount() {
        Bench bench;
        auto* mode = sparkOutEditor(bench);
        QVERIFY(mode);
        QTest::keyClick(mode, Qt::Key_Down);
        auto* count = bench.table.view().findChild<NumberField*>();
        QVERIFY(count && count->isVisible());
        const int good = bench.stages()[1].spark_out.count;
        typeOver(*count, QStringLiteral("2.5"));
        bench.select(0, 0); // closes the editor
        const QModelIndex cell = bench.table.view().model()->index(1, 3);
        QCOMPARE(cell.data().toString(), QStringLiteral("2.5"));
        QVERIFY(!cell.data(Qt::DecorationRole).isNull());
        QCOMPARE(bench.table.refusals().size(), 1u);
        QCOMPARE(bench.table.refusals().front().path, std::string("/cycle/stages/1/spark_out"));
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
        QVERIFY(bench.stages()[1].spark_out.count == 2
                || bench.stages()[1].spark_out.count == good);

        mode = sparkOutEditor(bench); // opened again it shows what was refused
        count = bench.table.view().findChild<NumberField*>();
        QCOMPARE(count->text(), QStringLiteral("2.5"));
        QTest::keyClick(mode, Qt::Key_Down); // until size: nothing to count
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::untilSize);
        QVERIFY(bench.table.refusals().empty());
        QTest::keyClick(mode, Qt::Key_Up); // and to be counted again
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
        QCOMPARE(bench.table.refusals().size(), 1u);
        QVERIFY(bench.table.dropRefusal("/cycle/stages/1/spark_out"));
        QVERIFY(bench.table.refusals().empty());
    }

    void theCountOfASparkOutIsReachedByTab() {
        Bench bench;
        QApplication::setActiveWindow(&bench.table);
        auto* mode = sparkOutEditor(bench);
        QTest::keyClick(mode, Qt::Key_Down);
        QTest::keyClick(mode, Qt::Key_Tab);
        auto* count = bench.table.view().findChild<NumberField*>();
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(count));
        count->selectAll();
        QTest::keyClicks(count, QStringLiteral("6"));
        QTest::keyClick(count, Qt::Key_Return);
        QTRY_COMPARE(bench.stages()[1].spark_out.count, 6);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
    }

    void aButtonFitsStocksThatDoNotAddUp() {
        Bench bench;
        auto* fit = bench.table.findChild<QPushButton*>(QStringLiteral("fitStocks"));
        QVERIFY(fit && !fit->isVisible());
        Project thicker = bench.document.project();
        thicker.part->stock_mm = 0.2;
        bench.document.edit(thicker, {"Input", "Stock"});
        QVERIFY(fit->isVisible());
        QVERIFY(fit->text().contains(QLocale().toString(0.16)));
        QTest::mouseClick(fit, Qt::LeftButton);
        QVERIFY(!fit->isVisible());
        QCOMPARE(bench.stages()[0].stock_mm, 0.16);
        QCOMPARE(bench.stages()[1].stock_mm, 0.04);
        bench.document.undo();
        QCOMPARE(bench.stages()[0].stock_mm, 0.11);
        QVERIFY(fit->isVisible());
        thicker.part->stock_mm = 0.02; // less than the last stage has
        bench.document.edit(thicker, {"Input", "Stock"});
        QVERIFY(fit->text().contains(QStringLiteral("in proportion")));
        fit->setFocus();
        QTest::keyClick(fit, Qt::Key_Space);
        QVERIFY(std::abs(bench.stockSum() - 0.02) < 1e-12);
    }

    void escapeTakesBackAnotherSparkOut() {
        Bench bench;
        auto* mode = sparkOutEditor(bench);
        QTest::keyClick(mode, Qt::Key_Down);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
        QTest::keyClick(mode, Qt::Key_Escape);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::none);
    }

    void aPlungeCycleShowsItsOwnColumns() {
        Bench bench(Operation::plunge);
        QCOMPARE(heads(bench.table.view()),
                 words({"Radial feed, mm/min", "Stock per side, mm", "Spark-out", "Time, s"}));
        bench.select(0, 0);
        bench.typeOver(QStringLiteral("0.8"));
        QCOMPARE(bench.stages()[0].radial_feed_mm_min.value(), 0.8);
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

    // The first stage takes the stock that the later ones leave of the part's stock, whatever it
    // states.
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

} // namespace sparkout::test_stage_table_stages

SPARKOUT_TEST(test_stage_table_stages, TestStageTableStages)
#include "test_stage_table_stages.moc"
