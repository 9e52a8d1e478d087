// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The stage table and the clipboard: cells of a spreadsheet pasted, refused, copied.
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "ui/text/number_text.h"

#include <QApplication>
#include <QClipboard>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLocale>
#include <QTemporaryDir>

#include <random>

namespace sparkout::test_stage_table_paste {

using namespace stage_table_bench;
using stage_table_bench::Bench;

void paste(Bench& bench, const QString& text) {
    QApplication::clipboard()->setText(text);
    QTest::keySequence(&bench.table.view(), QKeySequence::Paste);
}

QString copied(Bench& bench, Qt::KeyboardModifiers modifiers = Qt::ControlModifier) {
    QApplication::clipboard()->clear();
    QTest::keyClick(&bench.table.view(), Qt::Key_C, modifiers);
    return QApplication::clipboard()->text();
}

QString reasons(const Bench& bench) {
    return bench.table.findChild<QLabel*>(QStringLiteral("reasons"))->text();
}

class TestStageTablePaste : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void cellsAreTakenFromTheSelectedOneOnInOneStep() {
        Bench bench;
        QCOMPARE(bench.stages().size(), 2u);
        bench.select(0, 0);
        paste(bench, QStringLiteral("0,006\t1\u00a0500\t0,09\r\n0.003\t900\t0.06\r\n"));
        QCOMPARE(bench.stages().size(), 2u);
        QCOMPARE(bench.stages()[0].radial_feed_mm, std::optional(0.006));
        QCOMPARE(bench.stages()[0].axial_feed_mm_min, std::optional(1500.0));
        QCOMPARE(bench.stages()[0].stock_mm, 0.09);
        QCOMPARE(bench.stages()[1].radial_feed_mm, std::optional(0.003));
        QCOMPARE(bench.stages()[1].stock_mm, 0.06);
        QCOMPARE(bench.document.undoText(), QStringLiteral("Paste"));
        QCOMPARE(bench.table.view().selectionModel()->selectedIndexes().size(), 6);
        bench.document.undo();
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(bench.stages()[0].radial_feed_mm, std::optional(0.004));
    }

    void headsOfAnotherTableAreLeftOut() {
        Bench bench(0, 0);
        paste(bench, QStringLiteral("St, mm\tSax, mm/min\tStock\n0.006\t1500\t0.09\n"
                                    "0.003\t900\t0.06\n"));
        QCOMPARE(bench.stages().size(), 2u);
        QCOMPARE(bench.stages()[0].radial_feed_mm, std::optional(0.006));
        QCOMPARE(bench.stages()[1].axial_feed_mm_min, std::optional(900.0));
        QCOMPARE(bench.stages()[1].stock_mm, 0.06);
        paste(bench, QStringLiteral("0.006\tfast\n0.003\t900")); // no heads: a number beside
        QVERIFY(reasons(bench).contains(QStringLiteral("“fast” is not a number")));
    }

    void rowsThatDoNotSufficeAreAdded() {
        Bench bench;
        const Stage last = bench.stages()[1];
        bench.select(1, 2);
        paste(bench, QStringLiteral("0.03\n0.02\n0.01"));
        QCOMPARE(bench.stages().size(), 4u);
        QCOMPARE(bench.stages()[1].stock_mm, 0.03);
        QCOMPARE(bench.stages()[3].stock_mm, 0.01);
        QCOMPARE(bench.stages()[3].radial_feed_mm, last.radial_feed_mm); // of the row before
        bench.document.undo();
        QCOMPARE(bench.stages().size(), 2u);
        QVERIFY(!bench.document.canUndo());
    }

    void aRefusedCellIsNamedAndNothingIsTaken_data() {
        addColumns<int, int, QString, QString>("row", "column", "text", "reason");
        const auto line = [](const char* name, int row, int column, const char* text,
                             const char* reason) { addRow(name, row, column, text, reason); };
        line("word", 0, 2, "0.1\nabc",
             "Stage 2, Stock per side: “abc” is not a number; allowed: 0 to 5\u00a0mm");
        line("range", 0, 2, "7,5",
             "Stage 1, Stock per side: “7,5” is out of range; allowed: 0 to 5\u00a0mm");
        line("empty", 0, 1, "1500\t0.1\n\t0.05",
             "Stage 2, Axial feed: a number is missing; allowed: 0.01 to 100000\u00a0mm/min");
        line("wide", 0, 3, "1\t2\t3", "1 column");
        line("sparks", 0, 3, "3", "Stage 1, Spark-out: “3”: only the last stage may spark out");
        line("spark-out", 1, 3, "soon",
             "Stage 2, Spark-out: spark-out “soon” is invalid; allowed: 1 to 100000, “none”, "
             "“until size”");
        line("feed", 1, 0, "0.002\t900\t0.04\t5",
             "Stage 2, Radial feed: “0.002” cannot be entered: this row does not use the column");
        line("heads", 0, 0, "Stock per side, mm\n", "there are no rows below the headings");
    }
    void aRefusedCellIsNamedAndNothingIsTaken() {
        QFETCH(int, row);
        QFETCH(int, column);
        QFETCH(QString, text);
        QFETCH(QString, reason);
        Bench bench;
        const std::vector<Stage> before = bench.stages();
        bench.select(row, column);
        paste(bench, text);
        QVERIFY2(reasons(bench).contains(QStringLiteral("Not pasted: ") + reason.toHtmlEscaped()),
                 qPrintable(reasons(bench)));
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(bench.stages()[0].stock_mm, before[0].stock_mm);
        QCOMPARE(bench.stages().size(), before.size());
        QTest::keyClick(&bench.table.view(), Qt::Key_Escape);
        QCOMPARE(reasons(bench), QString());
    }

    /// The next edit of anything, saving, and another project leave it without a meaning.
    void whatWasNotPastedIsSaidUntilSomethingElseIsDone() {
        const QTemporaryDir folder;
        const auto refused = [](Bench& bench) {
            bench.select(0, 0);
            paste(bench, QStringLiteral("abc\tdef"));
            return reasons(bench).contains(QStringLiteral("Not pasted"));
        };
        Bench bench;
        QVERIFY(refused(bench));
        Project edited = bench.document.project();
        edited.title = "Another title";
        bench.document.edit(edited, {"Edit", "Edit"});
        QCOMPARE(reasons(bench), QString());
        QVERIFY(refused(bench));
        QVERIFY(!bench.document.saveAs(folder.filePath(QStringLiteral("a.sparkout"))));
        QCOMPARE(reasons(bench), QString());
        QVERIFY(refused(bench));
        bench.document.startUntitled(newProject(Operation::traverse));
        QCOMPARE(reasons(bench), QString());
        QVERIFY(refused(bench));
        paste(bench, QStringLiteral("0.006"));
        QCOMPARE(reasons(bench), QString());
    }

    void moreRefusedCellsThanAreShownAreCounted() {
        Bench bench(0, 0);
        paste(bench, QStringLiteral("a\tb\tc\nd\te\tf\ng\th\ti"));
        QCOMPARE(reasons(bench).count(QStringLiteral("Not pasted")), 6);
        QVERIFY(reasons(bench).contains(QStringLiteral("4 further cell")));
    }

    void aSparkOutStaysTheLastWhereItIsNotGiven() {
        Bench bench;
        Project sparks = bench.document.project();
        sparks.cycle->stages.back().sparkOutFor(4);
        sparks.cycle->stages.back().radial_feed_mm.reset();
        bench.document.startUntitled(sparks);
        bench.select(0, 0);
        paste(bench, QStringLiteral("0.006\t1500\t0.08\n0.004\t1200\t0.04\n0.002\t900\t0.03"));
        QCOMPARE(bench.stages().size(), 4u);
        QCOMPARE(bench.stages()[2].radial_feed_mm, std::optional(0.002));
        QVERIFY(bench.stages()[2].feeds());
        QCOMPARE(bench.stages()[3].sparkOutSteps(), std::optional(4));
        bench.select(0, 3);
        paste(bench, QStringLiteral("none\nnone\nnone\nuntil size"));
        QVERIFY(bench.stages()[3].waitsForSize());
    }

    /// Whatever the stages are: all of it copied, pasted over others, is the same.
    void aCopiedTableComesBackTheSameInEitherLocale() {
        std::mt19937 random(3);
        const auto number = [&random](double low, double high) {
            return std::uniform_real_distribution<>(low, high)(random);
        };
        for (const QLocale& locale : {QLocale(QLocale::English, QLocale::UnitedStates),
                                      QLocale(QLocale::Russian, QLocale::Russia)}) {
            QLocale::setDefault(locale);
            for (int i = 0; i < 20; ++i) {
                Bench bench;
                Project project = bench.document.project();
                const Stage some = project.cycle->stages.front();
                project.cycle->stages.assign(1 + random() % 6, some);
                for (Stage& stage : project.cycle->stages) {
                    stage.radial_feed_mm = number(0.001, 0.05);
                    stage.axial_feed_mm_min = number(50, 6000);
                    stage.stock_mm = number(0, 0.2);
                }
                if (random() % 2) {
                    project.cycle->stages.back().sparkOutFor(int(1 + random() % 9));
                    project.cycle->stages.back().radial_feed_mm.reset();
                }
                bench.document.startUntitled(project);
                const QString table = copied(bench, Qt::ControlModifier | Qt::ShiftModifier);
                bench.document.startUntitled(newProject(Operation::traverse));
                bench.select(1, 1);
                paste(bench, table);
                QCOMPARE(bench.stages().size(), project.cycle->stages.size());
                for (std::size_t k = 0; k < bench.stages().size(); ++k) {
                    const Stage& is = bench.stages()[k];
                    const Stage& was = project.cycle->stages[k];
                    QCOMPARE(is.radial_feed_mm, was.radial_feed_mm);
                    QCOMPARE(is.axial_feed_mm_min, was.axial_feed_mm_min);
                    QCOMPARE(is.stock_mm, was.stock_mm);
                    QCOMPARE(is.sparkOutSteps(), was.sparkOutSteps());
                }
                bench.document.undo();
                QVERIFY(!bench.document.canUndo());
            }
        }
    }

    void theSelectionIsCopiedByItself() {
        QLocale::setDefault(QLocale(QLocale::Russian, QLocale::Russia));
        Bench bench(0, 1);
        QCOMPARE(copied(bench), QStringLiteral("1800\n"));
        QTest::keyClick(&bench.table.view(), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&bench.table.view(), Qt::Key_Down, Qt::ShiftModifier);
        const Stage& second = bench.stages()[1];
        QCOMPARE(copied(bench), QStringLiteral("1800\t0,11\n%1\t0,04\n")
                                    .arg(showNumber(*second.axial_feed_mm_min, QLocale())));
        paste(bench, QStringLiteral("1700\t0,1\n")); // from the first of the selected ones on
        QCOMPARE(bench.stages()[0].axial_feed_mm_min, std::optional(1700.0));
        QCOMPARE(bench.stages()[0].stock_mm, 0.1);
    }
};

} // namespace sparkout::test_stage_table_paste

SPARKOUT_TEST(test_stage_table_paste, TestStageTablePaste)
#include "test_stage_table_paste.moc"
