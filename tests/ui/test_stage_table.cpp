// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/number_field.h"
#include "ui/inputs/stage_model.h"
#include "ui/inputs/stage_table.h"
#include "ui/session/operation.h"

#include "core/project/validate.h"

#include <QApplication>
#include <QComboBox>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <clocale>
#include <memory>

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

} // namespace

class TestStageTable : public QObject {
    Q_OBJECT

private slots:
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

    void insertAddsAStageAndDeleteRemovesItWithTheSumOfStocksKept() {
        Bench bench;
        const double sum = bench.stockSum();
        bench.select(0, 0);
        QTest::keyClick(&bench.table.view(), Qt::Key_Insert);
        QCOMPARE(bench.stages().size(), 3u);
        QCOMPARE(bench.table.view().currentIndex().row(), 1);
        QVERIFY(std::abs(bench.stockSum() - sum) < 1e-12);
        QVERIFY(!hasErrors(validate(bench.document.project())));
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete);
        QCOMPARE(bench.stages().size(), 2u);
        QVERIFY(std::abs(bench.stockSum() - sum) < 1e-12);
        bench.document.undo();
        bench.document.undo();
        QCOMPARE(bench.stages().size(), 2u);
        QVERIFY(!bench.document.canUndo());
    }

    void theLastStageThatIsLeftCannotBeRemoved() {
        Bench bench;
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete);
        QTest::keyClick(&bench.table.view(), Qt::Key_Delete);
        QCOMPARE(bench.stages().size(), 1u);
    }

    void controlArrowsMoveTheStageAndTheSelectionGoesWithIt() {
        Bench bench;
        bench.select(1, 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.001);
        QCOMPARE(bench.table.view().currentIndex().row(), 0);
        QCOMPARE(bench.table.view().currentIndex().column(), 1);
        QTest::keyClick(&bench.table.view(), Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(bench.stages()[1].radial_feed_mm.value(), 0.001);
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
        QCOMPARE(bench.table.view().model()->columnCount(), 3);
        bench.select(0, 0);
        auto* editor = bench.openEditor();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("0.8"));
        QCOMPARE(bench.stages()[0].radial_feed_mm_min.value(), 0.8);
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

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    TestStageTable test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_stage_table.moc"
