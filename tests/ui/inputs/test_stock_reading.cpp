// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Stock entered per side or on the diameter; the project keeps it per side.
#include "core/file/project_file.h"
#include "core/project/validate.h"
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/support/untitled.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLocale>

#include <algorithm>

namespace sparkout::test_stock_reading {

constexpr int stockColumn = 2;

void type(NumberField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

QString cell(const stage_table_bench::Bench& bench, int row) {
    return bench.table.view().model()->index(row, stockColumn).data().toString();
}

class TestStockReading : public QObject {
    Q_OBJECT

private slots:
    void init() {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        StockReading::instance().setOnDiameter(false);
    }
    void cleanup() { StockReading::instance().setOnDiameter(false); }

    void theFieldShowsAndTakesTheStockOnTheDiameter() {
        Document document;
        Project project = newProject(Operation::traverse);
        project.part->stock_mm = 0.25;
        document.startUntitled(project);
        FormPage page(Page::part, document);
        page.show();
        auto* field = page.findChild<NumberField*>(QStringLiteral("/part/stock_mm"));
        QVERIFY(field);
        QCOMPARE(field->text(), QStringLiteral("0.25"));
        QCOMPARE(field->accessibleName(), QStringLiteral("Stock per side, mm"));

        StockReading::instance().setOnDiameter(true);
        page.retranslate();
        QCOMPARE(field->text(), QStringLiteral("0.5"));
        QCOMPARE(field->accessibleName(), QStringLiteral("Stock on diameter, mm"));
        QVERIFY(field->toolTip().contains(QStringLiteral("on the diameter")));
        QVERIFY2(field->toolTip().contains(QStringLiteral("up to 10")),
                 qPrintable(field->toolTip()));
        const auto labels = page.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text().startsWith(QStringLiteral("Stock on diameter"))
                   && label->text().contains(QStringLiteral("2Π"));
        }));
        QVERIFY(sameProject(document.project(), project)); // the reading alone changed
        QVERIFY(!document.canUndo());

        type(*field, QStringLiteral("0,9/3"));
        QCOMPARE(field->text(), QStringLiteral("0.3"));
        QCOMPARE(document.project().part->stock_mm, 0.15);
        QVERIFY(writeProject(document.project()).find("\"stock_mm\": 0.15") != std::string::npos);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(field->text(), QStringLiteral("0.4"));
        QCOMPARE(document.project().part->stock_mm, 0.2);
        document.undo();
        page.retranslate();
        QVERIFY(field->text() != QStringLiteral("0.4"));

        type(*field, QStringLiteral("10.5"));
        QVERIFY(field->refused());
        QVERIFY2(field->refusal().contains(QStringLiteral("up to 10")),
                 qPrintable(field->refusal()));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!field->refused());
    }

    void whatIsBeingTypedIsTakenAsItWasMeant() {
        Untitled document(newProject(Operation::traverse));
        FormPage page(Page::part, document);
        page.show();
        auto* field = page.findChild<NumberField*>(QStringLiteral("/part/stock_mm"));
        typeOver(*field, QStringLiteral("0.31")); // per side
        StockReading::instance().setOnDiameter(true);
        page.retranslate();
        QCOMPARE(document.project().part->stock_mm, 0.31);
        QCOMPARE(field->text(), QStringLiteral("0.62"));
    }

    void cellsOfTheStagesArePastedAndCopiedAsTheyRead() {
        StockReading::instance().setOnDiameter(true);
        stage_table_bench::Bench bench;
        const Project before = bench.document.project();
        QCOMPARE(cell(bench, 0), QString::number(2 * bench.stages()[0].stock_mm));
        bench.select(0, stockColumn);
        QApplication::clipboard()->setText(QStringLiteral("0,18\n0.12"));
        QTest::keySequence(&bench.table.view(), QKeySequence::Paste);
        QCOMPARE(bench.stages()[0].stock_mm, 0.09);
        QCOMPARE(bench.stages()[1].stock_mm, 0.06);
        QCOMPARE(cell(bench, 0), QStringLiteral("0.18"));
        bench.document.undo();
        QVERIFY(sameProject(bench.document.project(), before));

        bench.select(1, stockColumn);
        bench.enter(QStringLiteral("0.1+0.02"));
        QTRY_COMPARE(bench.stages()[1].stock_mm, 0.06);
        QCOMPARE(cell(bench, 1), QStringLiteral("0.12"));

        QTest::keyClick(&bench.table.view(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QString table = QApplication::clipboard()->text();
        QVERIFY2(table.contains(QStringLiteral("Stock on diameter, mm")), qPrintable(table));
        QVERIFY(table.contains(QStringLiteral("\t0.12\t")));
    }

    // A table that was copied per side does not double the stock.
    void aTableOfTheOtherReadingIsTakenByItsHeads() {
        for (const bool onDiameter : {false, true}) {
            StockReading::instance().setOnDiameter(onDiameter);
            stage_table_bench::Bench bench;
            bench.select(0, 0);
            QApplication::clipboard()->setText(QStringLiteral("Stock per side, mm\n0.09\n0.06\n"));
            QTest::keySequence(&bench.table.view(), QKeySequence::Paste);
            QCOMPARE(bench.stages().size(), 2u);
            QCOMPARE(bench.stages()[0].stock_mm, 0.09);
            QApplication::clipboard()->setText(QStringLiteral("Stock on diameter, mm\n0.2\n0.1\n"));
            QTest::keySequence(&bench.table.view(), QKeySequence::Paste);
            QCOMPARE(bench.stages()[0].stock_mm, 0.1);
            QCOMPARE(bench.stages()[1].stock_mm, 0.05);
        }
    }

    void messagesSayWhichReadingTheyHave() {
        Project project = newProject(Operation::traverse);
        project.part->stock_mm = 0.25;
        project.cycle->stages.back().stock_mm += 0.01;
        const Issues issues = validate(project);
        const auto sum = std::ranges::find(issues, IssueCode::stocksDoNotSumUp, &Issue::code);
        QVERIFY(sum != issues.end());
        QVERIFY2(issueText(*sum).contains(QStringLiteral("0.25 mm")), qPrintable(issueText(*sum)));
        StockReading::instance().setOnDiameter(true);
        const QString text = issueText(*sum);
        QVERIFY2(text.contains(QStringLiteral("0.5 mm"))
                     && text.endsWith(QStringLiteral("(stock on diameter)")),
                 qPrintable(text));
        QVERIFY(fileIssueText(*sum).contains(QStringLiteral("0.25 mm"))); // of a file's faults
        QVERIFY(inputLocation("/part/stock_mm").contains(QStringLiteral("Stock on diameter")));
        QVERIFY(locationText("/part/stock_mm").contains(QStringLiteral("Stock per side")));
    }

    void theChoiceOfTheMenuIsKeptAndShownEverywhere() {
        Bench bench(QStringLiteral("ru"));
        Project project = newProject(Operation::traverse);
        project.part->stock_mm = 0.25;
        bench.window->document().startUntitled(project);
        bench.settle();
        QAction* const action = bench.action("stockOnDiameter");
        QVERIFY(action && action->isCheckable() && !action->isChecked());
        bench.window->inputs().showPage(0);
        auto* field =
            bench.window->inputs().findChild<NumberField*>(QStringLiteral("/part/stock_mm"));
        QVERIFY(field);
        action->trigger();
        bench.settle();
        QCOMPARE(field->text(), QStringLiteral("0,5"));
        QCOMPARE(field->accessibleName(), QStringLiteral("Припуск на диаметр, мм"));
        QVERIFY(bench.settings.stockOnDiameter());
        QVERIFY(sameProject(bench.window->document().project(), project));
        action->trigger();
        bench.settle();
        QCOMPARE(field->text(), QStringLiteral("0,25"));
        QVERIFY(!bench.settings.stockOnDiameter());
    }
};

} // namespace sparkout::test_stock_reading

SPARKOUT_TEST(test_stock_reading, TestStockReading)
#include "test_stock_reading.moc"
