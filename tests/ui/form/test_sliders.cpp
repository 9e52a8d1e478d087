// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "core/study/new_project.h"
#include "tests/whole_project.h"
#include "ui/form/number_field.h"
#include "ui/form/value_slider.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/row_sliders.h"
#include "ui/inputs/stage_table.h"
#include "ui/session/document.h"
#include "ui/text/number_text.h"

#include "core/file/project_file.h"

#include "tests/registry.h"

#include <QAccessible>
#include <QApplication>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>

namespace sparkout::test_sliders {

enum PageIndex { partPage = 0, wheelPage = 2, machinePage = 3, cyclePage = 5 };

struct Bench {
    explicit Bench(PageIndex page, Operation operation = Operation::traverse) : panel(document) {
        panel.resize(360, 420);
        panel.show();
        document.startUntitled(newProject(operation));
        panel.showPage(page);
        QApplication::processEvents();
    }
    [[nodiscard]] ValueSlider* slider(const char* path) const {
        return panel.findChild<ValueSlider*>(QString::fromLatin1(path) + QStringLiteral("/slider"));
    }
    [[nodiscard]] NumberField* field(const char* path) const {
        return panel.findChild<NumberField*>(QString::fromLatin1(path));
    }
    [[nodiscard]] FormPage& page(PageIndex index) { return *panel.pages()[index]; }

    Document document;
    InputsPanel panel;
};

void turnWheel(QWidget& widget, int notches) {
    const QPointF at = widget.rect().center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, notches * 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event); // only these go on to the parents
    qApp->notify(&widget, &event);
}

void press(ValueSlider& slider) {
    QTest::mousePress(&slider, Qt::LeftButton, {}, slider.handle());
}

void dragTo(ValueSlider& slider, int x) {
    QTest::mouseMove(&slider, QPoint(x, slider.height() / 2));
}

void release(ValueSlider& slider) {
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, slider.handle());
}

class TestSliders : public QObject {
    Q_OBJECT

private slots:
    void aDragChangesTheInputAtOnceAndIsOneStepOfTheHistory() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        const std::string before = writeProject(bench.document.project());
        QSignalSpy changed(&bench.document, &Document::changed);
        press(slider);
        for (int x = slider.handle().x(); x < slider.width() - 20; x += 5) {
            dragTo(slider, x);
            QCOMPARE(bench.document.project().wheel->dullness, slider.value().value());
        }
        release(slider);
        QVERIFY2(changed.count() > 5, "the curves follow the drag");
        QVERIFY(bench.document.project().wheel->dullness > 0.1);
        QCOMPARE(bench.field("/wheel/dullness")->text(),
                 showNumber(bench.document.project().wheel->dullness, QLocale()));
        bench.document.undo();
        QCOMPARE(writeProject(bench.document.project()), before);
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(slider.value().value(), bench.document.project().wheel->dullness);
    }

    void twoDragsAreTwoSteps() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        for (const int x : {60, 100}) {
            press(slider);
            dragTo(slider, x);
            release(slider);
        }
        const double second = bench.document.project().wheel->dullness;
        bench.document.undo();
        QVERIFY(bench.document.project().wheel->dullness < second);
        QVERIFY(bench.document.canUndo());
        bench.document.undo();
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
    }

    void escapeDuringADragGoesBackToTheOldValueAndLeavesNoStep() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        press(slider);
        dragTo(slider, slider.width() - 10);
        QVERIFY(bench.document.project().wheel->dullness > 0.1);
        QTest::keyClick(&slider, Qt::Key_Escape);
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
        QVERIFY(!bench.document.canUndo());
        dragTo(slider, slider.width() / 2); // the button is still down
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
        release(slider);
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
    }

    void aPressBesideTheHandleBringsItToThePointer() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() - 3, 7));
        QCOMPARE(bench.document.project().wheel->dullness, 0.25);
        QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(3, 7));
        QCOMPARE(bench.document.project().wheel->dullness, 0.0);
    }

    void takingTheHandleChangesNothing() {
        Bench bench(partPage);
        Project odd = bench.document.project();
        odd.part->stock_mm = 0.15137;
        bench.document.startUntitled(odd);
        ValueSlider& slider = *bench.slider("/part/stock_mm");
        press(slider);
        release(slider);
        QCOMPARE(bench.document.project().part->stock_mm, 0.15137);
        QVERIFY(!bench.document.canUndo());
    }

    void aChangeFromElsewhereEndsTheDrag() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        press(slider);
        dragTo(slider, slider.width() - 10);
        bench.document.undo(); // by its shortcut, with the button down
        QVERIFY(!slider.dragging());
        dragTo(slider, slider.width() / 2);
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
        release(slider);
    }

    void theWheelScrollsThePageAndChangesNothingWithoutTheFocus() {
        Bench bench(machinePage);
        bench.panel.resize(360, 240);
        QApplication::processEvents();
        QScrollBar& bar = *bench.page(machinePage).verticalScrollBar();
        QVERIFY(bar.maximum() > 0);
        const std::string before = writeProject(bench.document.project());
        for (ValueSlider* slider : bench.page(machinePage).findChildren<ValueSlider*>()) {
            bar.setValue(0);
            slider->clearFocus();
            turnWheel(*slider, -1);
            QVERIFY2(bar.value() > 0, qPrintable(slider->objectName()));
        }
        QCOMPARE(writeProject(bench.document.project()), before);
    }

    void theWheelTurnsASliderThatHasTheFocus() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        slider.setFocus();
        QVERIFY(slider.hasFocus());
        turnWheel(slider, 2);
        QCOMPARE(bench.document.project().wheel->dullness, slider.scale().stepped(0.02, 2));
    }

    void arrowAndPageKeysStepAndAPauseEndsTheStepOfTheHistory() {
        Bench bench(wheelPage);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Right);
        QTest::keyClick(&slider, Qt::Key_Up);
        const double stepped = bench.document.project().wheel->dullness;
        QCOMPARE(stepped, slider.scale().stepped(0.02, 2));
        QTest::qWait(1000);
        QTest::keyClick(&slider, Qt::Key_PageUp);
        QVERIFY(bench.document.project().wheel->dullness > stepped + 0.005);
        QTest::keyClick(&slider, Qt::Key_Home);
        QCOMPARE(bench.document.project().wheel->dullness, 0.0);
        bench.document.undo();
        QCOMPARE(bench.document.project().wheel->dullness, stepped);
        bench.document.undo();
        QCOMPARE(bench.document.project().wheel->dullness, 0.02);
    }

    void aRefusedTextGivesWayToTheSlider() {
        Bench bench(wheelPage);
        NumberField& field = *bench.field("/wheel/dullness");
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QStringLiteral("dull"));
        QCOMPARE(bench.panel.refusals().size(), 1u);
        ValueSlider& slider = *bench.slider("/wheel/dullness");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Right);
        QVERIFY(bench.panel.refusals().empty());
        QCOMPARE(field.text(), showNumber(bench.document.project().wheel->dullness, QLocale()));
    }

    void eachZoneOfTheComplianceHasItsSlider() {
        Bench bench(machinePage);
        ValueSlider& slider = *bench.slider("/machine/compliance_mm_per_n/nz");
        const auto before =
            std::get<ZoneCompliance>(bench.document.project().machine->compliance_mm_per_n);
        press(slider);
        dragTo(slider, slider.handle().x() + 20);
        release(slider);
        const auto after =
            std::get<ZoneCompliance>(bench.document.project().machine->compliance_mm_per_n);
        QVERIFY(after.nz > before.nz);
        QCOMPARE(after.rz1, before.rz1);
        bench.document.undo();
        QVERIFY(!bench.document.canUndo());
    }

    void theSlidersBelowTheStagesFollowTheSelectedOne() {
        Bench bench(cyclePage);
        auto& table = *bench.panel.findChild<StageTable*>();
        auto& strip = *table.findChild<RowSliders*>();
        ValueSlider* feed = strip.slider(QStringLiteral("radial_feed_mm"));
        QVERIFY(feed && strip.slider(QStringLiteral("axial_feed_mm_min"))
                && strip.slider(QStringLiteral("stock_mm")));
        QCOMPARE(feed->value().value(), 0.004);
        table.view().setCurrentIndex(table.view().model()->index(1, 0));
        feed = strip.slider(QStringLiteral("radial_feed_mm"));
        QCOMPARE(feed->value().value(), 0.002);
        press(*feed);
        dragTo(*feed, feed->width() - 10);
        release(*feed);
        const auto& stages = bench.document.project().cycle->stages;
        QVERIFY(stages[1].radial_feed_mm.value() > 0.02);
        QCOMPARE(stages[0].radial_feed_mm.value(), 0.004);
        QCOMPARE(table.view().model()->index(1, 0).data().toString(),
                 showNumber(stages[1].radial_feed_mm.value(), QLocale()));
        bench.document.undo();
        QVERIFY(!bench.document.canUndo());
    }

    void aSparkOutHasNoFeedToSlide() {
        Bench bench(cyclePage, Operation::plunge);
        Project project = bench.document.project();
        project.cycle->stages[1].spark_out = {SparkOut::Mode::count, 3};
        project.cycle->stages[1].radial_feed_mm_min.reset();
        bench.document.startUntitled(project);
        auto& table = *bench.panel.findChild<StageTable*>();
        auto& strip = *table.findChild<RowSliders*>();
        QVERIFY(strip.slider(QStringLiteral("radial_feed_mm_min")));
        table.view().setCurrentIndex(table.view().model()->index(1, 1));
        QVERIFY(!strip.slider(QStringLiteral("radial_feed_mm_min")));
        QVERIFY(strip.slider(QStringLiteral("stock_mm")));
    }

    void everySliderTellsAScreenReaderItsNameAndItsValueInItsUnit() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            Bench bench(machinePage, operation);
            QVERIFY(!bench.panel.pages().empty()); // which builds them
            const auto sliders = bench.panel.findChildren<ValueSlider*>();
            QVERIFY(sliders.size() > 8);
            for (ValueSlider* slider : sliders) {
                QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(slider);
                QVERIFY(reader && reader->role() == QAccessible::Slider);
                QVERIFY2(!reader->text(QAccessible::Name).isEmpty(),
                         qPrintable(slider->objectName()));
                QAccessibleValueInterface* value = reader->valueInterface();
                QVERIFY(value);
                QVERIFY(value->minimumValue().toDouble() < value->maximumValue().toDouble());
                QCOMPARE(value->currentValue().toDouble(), slider->value().value_or(0));
            }
            ValueSlider& dullness = *bench.slider("/wheel/dullness");
            QAccessible::queryAccessibleInterface(&dullness)->valueInterface()->setCurrentValue(
                0.1);
            QCOMPARE(bench.document.project().wheel->dullness, 0.1);
        }
    }

    void onlyTheNumbersToPlayWithHaveSliders() {
        Bench bench(partPage);
        QVERIFY(bench.slider("/part/stock_mm") && bench.slider("/part/initial_runout_mm"));
        QVERIFY(!bench.slider("/part/diameter_mm"));
    }
};

} // namespace sparkout::test_sliders

SPARKOUT_TEST(test_sliders, TestSliders)
#include "test_sliders.moc"
