// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/number_field.h"
#include "ui/inputs/stage_model.h"
#include "ui/inputs/stage_table.h"
#include "ui/session/operation.h"
#include "ui/session/run_controller.h"

#include "core/project/validate.h"

#include "tests/registry.h"
#include "tests/ui/window_bench.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLocale>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <clocale>
#include <functional>
#include <memory>

namespace test_stage_table {

using namespace sparkout;

namespace {

struct Bench {
    explicit Bench(Operation operation = Operation::traverse) : table(document) {
        table.resize(340, 400);
        table.show();
        document.startUntitled(newProject(operation));
        table.view().setFocus();
    }
    [[nodiscard]] const std::vector<Stage>& stages() const {
        return document.project().cycle.stages;
    }
    void select(int row, int column) {
        table.view().setCurrentIndex(table.view().model()->index(row, column));
    }
    [[nodiscard]] NumberField* openEditor() {
        QTest::keyClick(&table.view(), Qt::Key_F2);
        return table.view().findChild<NumberField*>();
    }
    [[nodiscard]] double stockSum() const {
        double sum = 0;
        for (const Stage& stage : stages()) {
            sum += stage.stock_mm;
        }
        return sum;
    }
    Document document;
    StageTable table;
};

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

/// Opens the spark-out of the last stage; its choice of what to do.
QComboBox* sparkOutEditor(Bench& bench) {
    const int row = int(bench.stages().size()) - 1;
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // an editor closed before
    bench.select(row, bench.table.view().model()->columnCount() - 2);
    QTest::keyClick(&bench.table.view(), Qt::Key_F2);
    return bench.table.view().findChild<QComboBox*>();
}

} // namespace

class TestStageTable : public QObject {
    Q_OBJECT

private slots:
    void deleteEmptiesACellWhetherItIsBeingEditedOrNot() {
        QTest::failOnWarning(QRegularExpression(QStringLiteral("editing failed")));
        for (const bool edited : {false, true}) {
            Bench bench;
            bench.select(0, 0);
            QVERIFY(!edited || bench.openEditor());
            QTest::keyClick(&bench.table.view(), Qt::Key_Delete);
            auto* field = bench.table.view().findChild<NumberField*>();
            QVERIFY(field && field->isVisible() && field->text().isEmpty());
            QTest::keyClick(field, Qt::Key_Escape);
            QVERIFY(bench.stages()[0].radial_feed_mm.has_value()); // as it was
        }
    }

    void returnAndAClickElsewhereAtOnceStoreTheNumberOnce() {
        Bench bench;
        QWidget elsewhere(&bench.table);
        elsewhere.setFocusPolicy(Qt::StrongFocus);
        elsewhere.show();
        bench.select(0, 0);
        NumberField* editor = bench.openEditor();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0.003"));
        WarningCatcher warnings;
        QTest::keyClick(editor, Qt::Key_Return); // commits later in the event loop …
        elsewhere.setFocus();                    // … in which the editor is closed by now
        QTRY_VERIFY(!bench.table.view().findChild<NumberField*>());
        QCOMPARE(warnings.take(), QStringList());
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.003);
        editor = bench.openEditor();
        QVERIFY(editor);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(!bench.table.view().findChild<NumberField*>());
        QVERIFY(bench.table.view().hasFocus());
    }

    /// By the view itself or by its rows; what the editor then says on losing the focus is late.
    void anEditorThatTheViewLetsGoOfIsSilent() {
        QTest::failOnWarning(QRegularExpression(QStringLiteral("editor")));
        using Close = std::function<void(Bench&)>;
        const std::initializer_list<Close> closings{
            [](Bench& bench) { bench.select(0, 1); },
            [](Bench& bench) { bench.table.view().setCurrentIndex({}); },
            [](Bench& bench) { bench.document.undo(); },
            [](Bench& bench) { bench.document.startUntitled(newProject(Operation::plunge)); },
            [](Bench& bench) { bench.table.hide(); },
        };
        for (const Close& close : closings) {
            for (const bool sparkOut : {false, true}) {
                Bench bench;
                QTest::keyClick(&bench.table.view(), Qt::Key_Insert);
                QApplication::setActiveWindow(&bench.table);
                QWidget* editor = nullptr;
                if (sparkOut) {
                    QComboBox* mode = sparkOutEditor(bench);
                    QTest::keyClick(mode, Qt::Key_Down);
                    QTest::keyClick(mode, Qt::Key_Tab);
                    editor = bench.table.view().findChild<NumberField*>();
                } else {
                    bench.select(int(bench.stages().size()) - 1, 0);
                    editor = bench.openEditor();
                }
                QTRY_COMPARE(QApplication::focusWidget(), editor);
                QTest::keyClicks(editor, QStringLiteral("0.0"));
                close(bench);
                QCoreApplication::processEvents();
            }
        }
    }

    void typingOverACellChangesTheStageWhileTyping() {
        Bench bench;
        bench.select(0, 0);
        QTest::keyClick(&bench.table.view(), Qt::Key_0);
        auto* editor = bench.table.view().findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral(",003"));
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.003);
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.table.view().currentIndex().row(), 0);
        bench.document.undo();
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.004);
    }

    void aRefusedTextStaysInTheCellMarkedAndTheStageKeepsItsValue() {
        Bench bench;
        bench.select(1, 2);
        auto* editor = bench.openEditor();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0.9"));
        QCOMPARE(bench.stages()[1].stock_mm, 0.9); // followed while it is a number
        QTest::keyClicks(editor, QStringLiteral("x"));
        QCOMPARE(bench.stages()[1].stock_mm, 0.04); // and taken back when it is none
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.stages()[1].stock_mm, 0.04);
        const QModelIndex cell = bench.table.view().model()->index(1, 2);
        QTRY_COMPARE(cell.data().toString(), QStringLiteral("0.9x"));
        QVERIFY(!cell.data(Qt::DecorationRole).isNull());
        QCOMPARE(bench.table.refusals().size(), 1u);
        QCOMPARE(bench.table.refusals().front().path, std::string("/cycle/stages/1/stock_mm"));
    }

    void aGoodNumberOverARefusedTextIsTaken() {
        Bench bench;
        bench.select(1, 2);
        auto* editor = bench.openEditor();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("2 um"));
        QTest::keyClick(editor, Qt::Key_Return);
        editor = bench.openEditor();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.stages()[1].stock_mm, 0.0);
        QVERIFY(bench.table.refusals().empty());
    }

    // The second click on a cell must not wait for a third: keys typed meanwhile belong to the
    // cell.
    void typingAfterASecondClickEditsTheClickedCell() {
        Bench bench;
        QTableView& view = bench.table.view();
        bench.select(1, 0);
        const QPoint middle = view.visualRect(view.model()->index(1, 0)).center();
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, middle);
        QTest::qWait(100);
        QTest::keyClick(&view, Qt::Key_0);
        auto* editor = view.findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral(".0015"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.stages()[1].radial_feed_mm.value(), 0.0015);
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.004);
    }

    void escapeTakesBackWhatWasTyped() {
        Bench bench;
        bench.select(1, 2);
        auto* editor = bench.openEditor();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0.07"));
        QCOMPARE(bench.stages()[1].stock_mm, 0.07);
        QTest::keyClick(editor, Qt::Key_Escape);
        QCOMPARE(bench.stages()[1].stock_mm, 0.04);
    }

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

    void theLastStageThatIsLeftCannotBeRemoved() {
        Bench bench;
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete, Qt::ControlModifier);
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(bench.stages().size(), 1u);
    }

    void controlArrowsMoveTheStageAndTheSelectionGoesWithIt() {
        Bench bench;
        bench.select(1, 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.002);
        QCOMPARE(bench.table.view().currentIndex().row(), 0);
        QCOMPARE(bench.table.view().currentIndex().column(), 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(bench.stages()[1].radial_feed_mm.value(), 0.002);
        QCOMPARE(bench.table.view().currentIndex().row(), 1);
    }

    void theButtonsDoTheSameAsTheKeys() {
        Bench bench;
        bench.select(0, 0);
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

    void theLastStageBecomesASparkOutUntilSizeByKeysAndFeedsNothing() {
        Bench bench;
        bench.select(1, 3);
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

    void aRefusedCountOfASparkOutStaysInTheCellAsLongAsThereIsSomethingToCount() {
        Bench bench;
        auto* mode = sparkOutEditor(bench);
        QVERIFY(mode);
        QTest::keyClick(mode, Qt::Key_Down);
        auto* count = bench.table.view().findChild<NumberField*>();
        QVERIFY(count && count->isVisible());
        const int good = bench.stages()[1].spark_out.count;
        count->setFocus();
        count->selectAll();
        QTest::keyClicks(count, QStringLiteral("2.5"));
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

    void aLongStageHasItsTimeWithoutAnExponent() {
        Bench bench;
        Project slow = bench.document.project();
        slow.cycle.stages[1].axial_feed_mm_min = 20;
        bench.table.setOutcome(runProject(slow, {}));
        const QAbstractItemModel& model = *bench.table.view().model();
        const QString time = model.index(1, model.columnCount() - 1).data().toString();
        QVERIFY2(QLocale().toDouble(time) > 1000 && !time.contains(u'E', Qt::CaseInsensitive),
                 qPrintable(time));
    }

    void escapeTakesBackAnotherSparkOut() {
        Bench bench;
        auto* mode = sparkOutEditor(bench);
        QTest::keyClick(mode, Qt::Key_Down);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::count);
        QTest::keyClick(mode, Qt::Key_Escape);
        QCOMPARE(bench.stages()[1].spark_out.mode, SparkOut::Mode::none);
    }

    void aRefusedTextOfACellGivesWayToItsValue() {
        Bench bench;
        bench.select(0, 0);
        auto* editor = bench.openEditor();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("much"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(bench.table.refusals().size(), 1u); // the editor closes by a later event
        QVERIFY(!bench.table.dropRefusal("/cycle/stages/1/radial_feed_mm"));
        QVERIFY(bench.table.dropRefusal("/cycle/stages/0/radial_feed_mm"));
        QCOMPARE(bench.table.view().model()->index(0, 0).data().toString(),
                 QLocale().toString(0.004));
    }

    void copyPutsTheTableOnTheClipboardForASpreadsheet() {
        Bench bench;
        bench.table.setOutcome(runProject(bench.document.project(), {}));
        QTest::keySequence(&bench.table.view(), QKeySequence::Copy);
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

    void eachStageShowsItsShareOfTimeAndOfStock() {
        Bench bench;
        QAbstractItemModel& model = *bench.table.view().model();
        const auto share = [&model](int row, int column) {
            return model.index(row, column).data(StageModel::shareRole);
        };
        QVERIFY(!share(0, 2).isValid()); // nothing has run
        const OutcomePtr outcome = runProject(bench.document.project(), {});
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
        project.cycle.stages[0].stock_mm = 0.05;
        bench.document.startUntitled(project);
        bench.table.setOutcome(runProject(project, {}));
        QVERIFY(
            std::abs(bench.table.view().model()->index(0, 2).data(StageModel::shareRole).toDouble()
                     - 0.11 / 0.15)
            < 1e-12);
    }

    void sharesOfTheLastGoodRunAreGreyWhileTheInputsAreFaulty() {
        Bench bench;
        QAbstractItemModel& model = *bench.table.view().model();
        bench.table.setOutcome(runProject(bench.document.project(), {}));
        const QVariant before = model.index(0, 4).data(StageModel::shareRole);
        QVERIFY(!model.index(0, 4).data(StageModel::staleRole).toBool());
        const QImage good = bench.table.view().grab().toImage();
        Project faulty = bench.document.project();
        faulty.part.radii_per_section = 35;
        bench.table.setOutcome(runProject(faulty, {}));
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
            bench.table.setOutcome(runProject(bench.document.project(), {}));
            QApplication::processEvents();
            QTableView& view = bench.table.view();
            QCOMPARE(view.horizontalScrollBar()->maximum(), 0);
            QCOMPARE(view.verticalScrollBar()->maximum(), 0);
        }
    }

    void aStageCanBeAddedBeforeASparkOut() {
        Bench bench;
        Project project = bench.document.project();
        project.cycle.stages[1].radial_feed_mm.reset();
        project.cycle.stages[1].spark_out = {SparkOut::Mode::count, 4};
        bench.document.startUntitled(project);
        bench.select(1, 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Insert);
        QCOMPARE(bench.stages().size(), 3u);
        QCOMPARE(bench.stages()[2].spark_out.count, 4);
        QVERIFY(!hasErrors(validate(bench.document.project())));
    }
};

} // namespace test_stage_table

SPARKOUT_TEST(test_stage_table, TestStageTable)
#include "test_stage_table.moc"
