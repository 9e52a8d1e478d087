// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The formulas of the step: those of the radius the cycle stands at, in the zone that was chosen.
#include "core/quality/visit_sheet.h"
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/window/dialogs/step_sheet.h"
#include "ui/window/playback_bar.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QPalette>
#include <QTextEdit>
#include <QToolButton>

namespace sparkout::test_step_sheet {

struct Sheet {
    explicit Sheet(const Project& project) : outcome(fixtures::run(project)), view(cycle) {
        view.resize(320, 500);
        view.show();
        cycle.setOutcome(outcome);
    }
    [[nodiscard]] QString text() const {
        return view.findChild<FormulaView*>()->text().replace(QChar::Nbsp, u' ');
    }
    [[nodiscard]] QString place() const { return view.findChild<QLabel*>()->text(); }
    /// Of the nth pass of the moment.
    [[nodiscard]] QString expected(std::size_t nth) const {
        return FormulaView::textOf(visitSheet(outcome->result, outcome->trajectory,
                                              cycle.progress().open + nth, cycle.radius()))
            .replace(QChar::Nbsp, u' ');
    }
    void toWorkingStroke() {
        cycle.toStroke(3);
        do {
            cycle.step(CursorUnit::revolution, 1);
        } while (cycle.progress().end - cycle.progress().open < 3);
    }
    CycleCursor cycle;
    OutcomePtr outcome;
    StepSheet view;
};

class TestStepSheet : public QObject {
    Q_OBJECT

private slots:
    void itHasTheNumbersOfTheMoment() {
        Sheet sheet(fixtures::traverseProject());
        sheet.toWorkingStroke();
        QVERIFY(sheet.place().startsWith(
            QStringLiteral("RZ1, working stroke (E3), stage 1, double stroke 4, ")));
        QCOMPARE(sheet.text(), sheet.expected(0));
        const QString before = sheet.text();
        sheet.cycle.step(CursorUnit::radius, -1);
        QCOMPARE(sheet.text(), sheet.expected(0));
        QVERIFY(sheet.text() != before);
    }

    void theChosenZoneStaysWhileItIsUnderTheWheel() {
        Sheet sheet(fixtures::traverseProject());
        sheet.toWorkingStroke();
        auto* zone = sheet.view.findChild<QComboBox*>();
        QCOMPARE(zone->count(), 3);
        zone->setFocus();
        QTest::keyClick(zone, Qt::Key_Down);
        QCOMPARE(sheet.text(), sheet.expected(1));
        sheet.cycle.step(CursorUnit::revolution, 1); // the exit dwell is in РЗ2 alone
        QCOMPARE(zone->count(), 1);
        QCOMPARE(sheet.text(), sheet.expected(0));
        do {
            sheet.cycle.step(CursorUnit::revolution, 1);
        } while (sheet.cycle.progress().end - sheet.cycle.progress().open < 3);
        QCOMPARE(zone->currentIndex(), 1);
        QCOMPARE(sheet.text(), sheet.expected(1));
    }

    void everySectionOfAPlungeHasItsOwn() {
        Project project = fixtures::plungeProject(3);
        project.machine->compliance_mm_per_n = std::vector<double>{2e-5, 4e-5, 8e-5};
        Sheet sheet(project);
        sheet.cycle.toStroke(20);
        auto* zone = sheet.view.findChild<QComboBox*>();
        QCOMPARE(zone->count(), 3);
        for (int section = 0; section < 3; ++section) {
            zone->setFocus();
            QTest::keyClick(zone, section == 0 ? Qt::Key_Home : Qt::Key_Down);
            QCOMPARE(sheet.text(), sheet.expected(static_cast<std::size_t>(section)));
        }
    }

    // Each side of an equation is a piece that is drawn, and is copied in one line.
    void theFormulasAreTypesetAndCopiedAsText() {
        Sheet sheet(fixtures::traverseProject());
        sheet.toWorkingStroke();
        auto* view = sheet.view.findChild<FormulaView*>();
        const QString characters = view->toPlainText();
        QVERIFY(characters.count(QChar::ObjectReplacementCharacter) >= 10);
        QVERIFY(!characters.contains(u'='));
        const QStringList lines = sheet.text().split(u'\n');
        QVERIFY(lines.size() > 3);
        for (qsizetype i = 1; i < lines.size(); ++i) {
            QVERIFY2(lines[i].count(QStringLiteral(" = ")) >= 1, qPrintable(lines[i]));
        }
        view->setFocus();
        QTest::keySequence(view, QKeySequence::SelectAll);
        QTest::keySequence(view, QKeySequence::Copy);
        QCOMPARE(QApplication::clipboard()->text().replace(QChar::Nbsp, u' '), sheet.text());
    }

    // The formulas are drawn in the colour of texts, within the view, in any width and type size.
    void theyFitTheViewAndHaveItsColour() {
        Sheet sheet(fixtures::traverseProject());
        sheet.toWorkingStroke();
        auto* view = sheet.view.findChild<FormulaView*>();
        for (const int width : {240, 320, 600}) {
            sheet.view.resize(width, 500);
            QVERIFY2(view->document()->size().width() <= view->viewport()->width() + 1,
                     qPrintable(QString::number(width)));
        }
        QPalette dark = view->palette();
        dark.setColor(QPalette::Base, Qt::black);
        dark.setColor(QPalette::Text, Qt::green);
        view->setPalette(dark);
        const QImage image = view->viewport()->grab().toImage();
        int green = 0;
        for (int y = image.height() / 4; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                green += image.pixelColor(x, y).green() > 150;
            }
        }
        QVERIFY2(green > 500, qPrintable(QString::number(green)));
    }

    void atTheBlankItSaysWhatToDo() {
        Sheet sheet(fixtures::traverseProject());
        sheet.cycle.setPosition(0);
        QVERIFY(sheet.text().isEmpty());
        QVERIFY(sheet.place().contains(QStringLiteral("Play")));
    }

    void theBarShowsAndHidesIt() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        auto* dock = bench.window->findChild<QDockWidget*>(QStringLiteral("step"));
        auto* button = bench.window->findChild<QToolButton*>(QStringLiteral("playTool"));
        QVERIFY(!dock->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        bench.settle();
        auto* sheet = bench.window->findChild<StepSheet*>();
        QVERIFY(dock->isVisible() && !sheet->visibleRegion().isEmpty());
        QVERIFY(!sheet->findChild<QTextEdit*>()->toPlainText().isEmpty());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(!dock->isVisible());
    }
};

} // namespace sparkout::test_step_sheet

SPARKOUT_TEST(test_step_sheet, TestStepSheet)
#include "test_step_sheet.moc"
