// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The cells of the stage table: typed over, refused, taken back.
#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "tests/ui/support/window_bench.h"
#include "ui/inputs/stage_model.h"

#include <QApplication>
#include <QLocale>
#include <QRegularExpression>

#include <cmath>
#include <functional>
#include <initializer_list>

namespace sparkout::test_stage_table_editing {

using namespace stage_table_bench;
using stage_table_bench::Bench;

class TestStageTableEditing : public QObject {
    Q_OBJECT

private slots:
    void deleteEmptiesACellWhetherItIsBeingEditedOrNot() {
        QTest::failOnWarning(QRegularExpression(QStringLiteral("editing failed")));
        for (const bool edited : {false, true}) {
            Bench bench(0, 0);
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
        NumberField* editor = bench.typeOver(QStringLiteral("0.003"));
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
        Bench bench(0, 0);
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

    /// Typed as a share of the wheel's width or per revolution: worked out when the cell is left.
    void anAxialFeedIsTypedAsAShareOfTheWidth() {
        for (const char* text : {"0.3B", "0,3 b"}) {
            Bench bench(0, 1);
            const Project& project = bench.document.project();
            const double wanted = 0.3 * project.wheel->width_mm * project.machine->work_speed_rpm;
            bench.enter(QString::fromUtf8(text));
            QTRY_VERIFY(!bench.table.view().findChild<NumberField*>());
            QVERIFY(std::abs(bench.stages()[0].axial_feed_mm_min.value() - wanted) < 1e-6);
            const QModelIndex cell = bench.table.view().model()->index(0, 1);
            QString share = cell.data(StageModel::formRole).toString();
            QCOMPARE(share.replace(u',', u'.'),
                     QStringLiteral("0.3 B")); // by the system's language
            QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(u"mm/rev"));
            QVERIFY(!bench.table.view().model()->index(0, 2).data(StageModel::formRole).isValid());
            bench.document.undo();
            QCOMPARE(bench.stages()[0].axial_feed_mm_min.value(), 1800.0);
        }
    }

    /// A stock goes by the steps of the wheel slide, which are those of the radial feed.
    void arrowKeysStepACellByTheMachine() {
        Bench bench;
        Project project = bench.document.project();
        project.machine->limits.radial_feed_mm = {{0.0005, 0.02, 0.0005}};
        project.machine->limits.axial_feed_mm_min = {{20, 1850, 50}};
        bench.document.edit(project, {"Input", "Machine"});
        const auto press = [&bench](int column, Qt::Key key) {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            bench.select(0, column);
            NumberField* editor = bench.openEditor();
            QTest::keyClick(editor, key);
            QTest::keyClick(editor, Qt::Key_Return);
            QTRY_VERIFY(!bench.table.view().findChild<NumberField*>());
        };
        press(0, Qt::Key_Up);
        QCOMPARE(bench.stages()[0].radial_feed_mm.value(), 0.0045);
        press(1, Qt::Key_Up); // 1800 lies between 1770 and 1820
        QCOMPARE(bench.stages()[0].axial_feed_mm_min.value(), 1820.0);
        press(1, Qt::Key_Up); // 1870 is beyond the machine
        QCOMPARE(bench.stages()[0].axial_feed_mm_min.value(), 1820.0);
        const double stock_mm = bench.stages()[0].stock_mm;
        press(2, Qt::Key_Down);
        QVERIFY(std::abs(bench.stages()[0].stock_mm - (stock_mm - 0.0005)) < 1e-12);
    }

    void aRefusedTextStaysInTheCellMarkedAndTheStageKeepsItsValue() {
        Bench bench(1, 2);
        auto* editor = bench.typeOver(QStringLiteral("0.9"));
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
        Bench bench(1, 2);
        bench.enter(QStringLiteral("2 um"));
        bench.enter(QStringLiteral("0"));
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
        Bench bench(1, 2);
        auto* editor = bench.typeOver(QStringLiteral("0.07"));
        QCOMPARE(bench.stages()[1].stock_mm, 0.07);
        QTest::keyClick(editor, Qt::Key_Escape);
        QCOMPARE(bench.stages()[1].stock_mm, 0.04);
    }

    void aRefusedTextOfACellGivesWayToItsValue() {
        Bench bench(0, 0);
        bench.enter(QStringLiteral("much"));
        QTRY_COMPARE(bench.table.refusals().size(), 1u); // the editor closes by a later event
        QVERIFY(!bench.table.dropRefusal("/cycle/stages/1/radial_feed_mm"));
        QVERIFY(bench.table.dropRefusal("/cycle/stages/0/radial_feed_mm"));
        QCOMPARE(bench.table.view().model()->index(0, 0).data().toString(),
                 QLocale().toString(0.004));
    }
};

} // namespace sparkout::test_stage_table_editing

SPARKOUT_TEST(test_stage_table_editing, TestStageTableEditing)
#include "test_stage_table_editing.moc"
