// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// What happens while one types: in the cells of the stages, in the forms, and when it is undone.
#include "core/project/machine.h"
#include "core/study/new_project.h"
#include "core/study/outcome.h"
#include "tests/whole_project.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/stage_table.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include "core/project/validate.h"

#include "tests/registry.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace sparkout::test_typing {

/// The inputs with a document whose outcomes they show at once.
struct Bench {
    explicit Bench(Operation operation = Operation::traverse) : panel(document) {
        panel.resize(360, 640);
        panel.show();
        QApplication::setActiveWindow(&panel);
        QObject::connect(&document, &Document::changed, &panel, [this] {
            const OutcomePtr outcome = evaluate(document.project(), {});
            faulty = faulty || !outcome->ran();
            panel.setOutcome(outcome);
        });
        QObject::connect(&document, &Document::stepped, &panel, &InputsPanel::revealPath);
        document.startUntitled(newProject(operation));
        for (FormPage* page : panel.pages()) {
            if (auto* found = page->findChild<StageTable*>()) {
                table = found;
            }
        }
        table->view().setFocus();
    }
    void select(int row, int column) const {
        table->view().setCurrentIndex(table->view().model()->index(row, column));
    }
    /// Types into the selected cell as into any table: the first key opens it.
    void type(const QString& text) const {
        for (const QChar sign : text) {
            QWidget* to = QApplication::focusWidget();
            QTest::keyClick(to ? to : &table->view(), sign.toLatin1());
        }
    }
    [[nodiscard]] NumberField* editor() const {
        return table->view().viewport()->findChild<NumberField*>();
    }
    [[nodiscard]] NumberField* field(const char* path) const {
        return panel.findChild<NumberField*>(QString::fromLatin1(path));
    }
    [[nodiscard]] const Stage& stage(std::size_t i) const {
        return document.project().cycle->stages[i];
    }
    [[nodiscard]] QString reasons() const {
        const auto* label = table->findChild<QLabel*>(QStringLiteral("reasons"));
        return label->isVisible() ? label->text() : QString();
    }
    Document document;
    InputsPanel panel;
    StageTable* table = nullptr;
    bool faulty = false; ///< whether any outcome was refused
};

void typeOver(QWidget& widget, const QString& text) {
    widget.setFocus();
    QTest::keySequence(&widget, QKeySequence::SelectAll);
    QTest::keyClicks(&widget, text);
}

class TestTyping : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void theBeginningOfASmallFeedIsNoErrorAndMovesNothing() {
        Bench bench;
        bench.select(0, 0);
        const int height = bench.table->sizeHint().height();
        for (const char sign : QByteArrayLiteral("0,00")) {
            bench.type(QString(QLatin1Char(sign)));
            QCOMPARE(bench.reasons(), QString());
            QCOMPARE(bench.table->sizeHint().height(), height);
            QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.004);
        }
        bench.type(QStringLiteral("5"));
        QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.005);
        QVERIFY(!bench.faulty);
    }

    void aFeedThatStaysZeroIsRefusedAfterAPauseAndOnLeaving_data() {
        QTest::addColumn<int>("key");
        QTest::newRow("pause") << 0;
        QTest::newRow("Enter") << int(Qt::Key_Return);
        QTest::newRow("Tab") << int(Qt::Key_Tab);
    }
    void aFeedThatStaysZeroIsRefusedAfterAPauseAndOnLeaving() {
        QFETCH(int, key);
        Bench bench;
        bench.select(0, 0);
        bench.type(QStringLiteral("0.0"));
        QCOMPARE(bench.reasons(), QString());
        if (key != 0) {
            QTest::keyClick(bench.editor(), Qt::Key(key));
        }
        QTRY_VERIFY2(bench.reasons().contains(QStringLiteral("0.000001 to 1")),
                     qPrintable(bench.reasons()));
        QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.004);
        QCOMPARE(bench.table->refusals().size(), std::size_t(1));
    }

    void arrowKeysStepTheWorkSpeedByTheMachine() {
        Bench bench;
        Project project = bench.document.project();
        project.machine->work_speed_rpm = 182;
        bench.document.edit(project, {"Input", "Machine"});
        bench.panel.revealPath("/machine/work_speed_rpm");
        NumberField* speed = bench.field("/machine/work_speed_rpm");
        QVERIFY(speed);
        QTest::keyClick(speed, Qt::Key_Up);
        QCOMPARE(bench.document.project().machine->work_speed_rpm, 183.0); // by its last digit
        project.machine->limits.work_speed_rpm = {{60, 600, 10}};
        bench.document.edit(project, {"Input", "Machine"}); // to 182 again
        QTest::keyClick(speed, Qt::Key_Up);
        QCOMPARE(bench.document.project().machine->work_speed_rpm, 190.0);
        QTest::keyClick(speed, Qt::Key_Down);
        QCOMPARE(bench.document.project().machine->work_speed_rpm, 180.0);
    }

    void hintAndMessageStateTheSameRange() {
        for (const char* key : {"radial_feed_mm", "radial_feed_mm_min"}) {
            const Field& field = *tableOf<Stage>().find(key);
            const bool traverse = std::string_view(key) == "radial_feed_mm";
            const QString range = rangeBrief(field.stated(), field.unit);
            QVERIFY2(limitsMarkup(field).contains(range), qPrintable(range));
            Project project = newProject(traverse ? Operation::traverse : Operation::plunge);
            Stage& stage = project.cycle->stages[0];
            (traverse ? stage.radial_feed_mm : stage.radial_feed_mm_min) = 0;
            const Issues issues = validate(project);
            const auto found = std::ranges::find(issues, IssueCode::feedMissing, &Issue::code);
            QVERIFY(found != issues.end());
            QVERIFY2(issueText(*found).contains(rangeBrief(field.stated(), "")),
                     qPrintable(issueText(*found)));
        }
    }

    // 4 of 40 leaves no room beside a wheel of 30 mm: not said before the 0 can come.
    void aLengthIsNotJudgedBeforeItIsTyped() {
        Bench bench;
        bench.panel.showPage(0);
        NumberField& length = *bench.field("/part/length_mm");
        const double before = length.value().value();
        typeOver(length, QStringLiteral("9"));
        QCOMPARE(bench.document.project().part->length_mm, before);
        QTest::keyClicks(&length, QStringLiteral("00"));
        QCOMPARE(bench.document.project().part->length_mm, 900.0);
        QVERIFY(!bench.faulty);
        typeOver(length, QStringLiteral("9"));
        QTest::keyClick(&length, Qt::Key_Return);
        QCOMPARE(bench.document.project().part->length_mm, 9.0); // it was meant
        QVERIFY(bench.faulty);
        QCOMPARE(length.remark().mark, Mark::error);
    }

    void aMessageThatGoesWhileOneTypesLeavesItsPlace() {
        Bench bench;
        bench.panel.showPage(0);
        NumberField& diameter = *bench.field("/part/diameter_mm");
        const auto* length = bench.field("/part/length_mm");
        typeOver(diameter, QStringLiteral("x"));
        QTRY_COMPARE(diameter.remark().mark, Mark::error);
        QTRY_VERIFY(length->mapTo(&bench.panel, QPoint()).y() > 0);
        QCoreApplication::processEvents();
        const int marked = length->mapTo(&bench.panel, QPoint()).y();
        typeOver(diameter, QStringLiteral("30"));
        QCoreApplication::processEvents();
        QCOMPARE(diameter.remark().mark, Mark::none);
        QCOMPARE(length->mapTo(&bench.panel, QPoint()).y(), marked);
        bench.field("/part/length_mm")->setFocus();
        QTRY_VERIFY(length->mapTo(&bench.panel, QPoint()).y() < marked);
    }

    void deleteClearsTheCellAndUndoRestoresIt() {
        Bench bench;
        bench.select(0, 0);
        QTest::keyClick(&bench.table->view(), Qt::Key_Delete);
        QCOMPARE(bench.document.project().cycle->stages.size(), std::size_t(2));
        QVERIFY(bench.editor());
        QCOMPARE(bench.editor()->text(), QString());
        QTest::keyClicks(bench.editor(), QStringLiteral("0.003"));
        QTest::keyClick(bench.editor(), Qt::Key_Return);
        QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.003);
        bench.document.undo();
        QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.004);
        QVERIFY(!bench.document.canUndo());
        QTRY_VERIFY(!bench.editor());
        bench.table->view().setFocus();
        QTest::keyClick(&bench.table->view(), Qt::Key_Delete); // left empty: refused, and kept
        QTest::keyClick(bench.editor(), Qt::Key_Return);
        QTRY_COMPARE(bench.panel.refusals().size(), std::size_t(1));
        QCOMPARE(bench.stage(0).radial_feed_mm.value(), 0.004);
        QVERIFY(bench.panel.dropNewestRefusal()); // what undo does first
        QVERIFY(bench.panel.refusals().empty());
        bench.table->view().setFocus();
        QTest::keyClick(&bench.table->view(), Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(bench.document.project().cycle->stages.size(), std::size_t(1));
        bench.document.undo();
        QCOMPARE(bench.document.project().cycle->stages.size(), std::size_t(2));
    }

    void aDigitInTheSparkOutCellIsItsCountAndEscapeTakesItBack() {
        Bench bench;
        bench.select(1, 3);
        const double feed = bench.stage(1).radial_feed_mm.value();
        bench.type(QStringLiteral("1"));
        QVERIFY(bench.stage(1).spark_out == (SparkOut{SparkOut::Mode::count, 1}));
        bench.type(QStringLiteral("2"));
        QVERIFY(bench.stage(1).spark_out == (SparkOut{SparkOut::Mode::count, 12}));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        if (QWidget* left = bench.table->view().viewport()->findChild<QComboBox*>()) {
            QTest::keyClick(left, Qt::Key_Escape);
        }
        QVERIFY(bench.stage(1).spark_out == SparkOut{});
        QCOMPARE(bench.stage(1).radial_feed_mm.value(), feed);
    }

    void deleteInTheSparkOutCellMakesItAnOrdinaryStage() {
        Bench bench;
        bench.select(1, 3);
        bench.type(QStringLiteral("7"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(bench.stage(1).spark_out.count, 7);
        QCOMPARE(bench.table->view().currentIndex(), bench.table->view().model()->index(1, 3));
        QTest::keyClick(&bench.table->view(), Qt::Key_Delete);
        QVERIFY(bench.stage(1).spark_out == SparkOut{});
        bench.document.undo();
        QCOMPARE(bench.stage(1).spark_out.count, 7);
    }

    void warningsAndErrorsOfTheTableKeepTheirColours() {
        Bench bench;
        Project project = bench.document.project();
        project.cycle->stages[0].radial_feed_mm = 0.2; // unusual
        project.cycle->stages[1].radial_feed_mm = 0;   // refused
        bench.document.edit(project, {});
        const QString text = bench.reasons();
        const QPalette colours = bench.table->palette();
        QVERIFY2(text.contains(markColor(Mark::error, colours).name()), qPrintable(text));
        QVERIFY2(text.contains(markColor(Mark::warning, colours).name()), qPrintable(text));
    }

    void undoBringsTheChangedFieldIntoSight() {
        Bench bench;
        bench.panel.showPage(0);
        NumberField& stock = *bench.field("/part/initial_runout_mm");
        typeOver(stock, QStringLiteral("0.03"));
        QTest::keyClick(&stock, Qt::Key_Return);
        bench.panel.showPage(3);
        QWidget elsewhere;
        elsewhere.setFocusPolicy(Qt::StrongFocus);
        elsewhere.show();
        QApplication::setActiveWindow(&elsewhere);
        elsewhere.setFocus();
        QVERIFY(!stock.isVisible());
        bench.document.undo();
        QTRY_VERIFY(stock.isVisible() && !stock.visibleRegion().isEmpty());
        QVERIFY(elsewhere.hasFocus()); // only from one input to another does the focus go along
        bench.panel.showPage(5);
        bench.document.redo();
        QTRY_VERIFY(stock.isVisible());
        QApplication::setActiveWindow(&bench.panel);
        bench.panel.showPage(5);
        bench.table->view().setFocus();
        bench.document.undo();
        QTRY_VERIFY(stock.hasFocus());
    }

    void undoOfAStageSelectsItsCell() {
        Bench bench;
        bench.select(1, 2);
        bench.type(QStringLiteral("0.05"));
        QTest::keyClick(bench.editor(), Qt::Key_Return);
        QTRY_VERIFY(!bench.editor());
        bench.select(0, 0);
        bench.panel.showPage(1);
        bench.document.undo();
        QTRY_VERIFY(bench.table->isVisible());
        QCOMPARE(bench.table->view().currentIndex(), bench.table->view().model()->index(1, 2));
    }

    void theHintOfAFieldDoesNotOutlastItsPage() {
        Bench bench;
        const auto* text =
            bench.panel.findChild<QWidget*>(QStringLiteral("hintStrip"))->findChild<QLabel*>();
        bench.panel.showPage(0);
        bench.field("/part/diameter_mm")->setFocus();
        QVERIFY(text->text().contains(QStringLiteral("Allowed")));
        const QList<QToolButton*> buttons = bench.panel.findChildren<QToolButton*>();
        const auto wheel = std::ranges::find_if(
            buttons, [](const QToolButton* b) { return b->accessibleName() == u"Wheel"; });
        QVERIFY(wheel != buttons.end());
        (*wheel)->setFocus();
        QTest::mouseClick(*wheel, Qt::LeftButton);
        QVERIFY(!bench.field("/part/diameter_mm")->isVisible());
        QCOMPARE(text->text(), HintStrip::tr("Help on the selected input appears here."));
    }
};

} // namespace sparkout::test_typing

SPARKOUT_TEST(test_typing, TestTyping)
#include "test_typing.moc"
