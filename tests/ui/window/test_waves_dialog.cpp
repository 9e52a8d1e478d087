// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The causes of counted waves in the window: those of the engine, for what is typed.
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/window_bench.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/number_field.h"
#include "ui/inputs/project_model.h"
#include "ui/session/document.h"
#include "ui/window/dialogs/waves_dialog.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QTimer>

#include <numbers>

namespace sparkout::test_waves_dialog {

/// A wheel of 2800 revolutions a minute over a work of 40.
Project letter() {
    Project project = fixtures::plunge();
    project.machine->work_speed_rpm = 40;
    project.machine->wheel_speed_m_s = std::numbers::pi * project.wheel->diameter_mm * 2800 / 60e3;
    project.machine->wheel_head_frequency_hz = 140; // 210 a turn
    return project;
}

class TestWavesDialog : public QObject {
    Q_OBJECT

private slots:
    void whatIsTypedIsFound() {
        Bench bench(QStringLiteral("en"));
        WavesDialog dialog(letter(), bench.settings, nullptr);
        dialog.show();
        auto& count = *dialog.findChild<NumberField*>();
        QCOMPARE(count.value(), std::optional(70.0)); // of the file's own speeds
        const auto& model = *dialog.findChild<CopyTable*>()->model();
        QCOMPARE(model.rowCount(), 2); // the wheel and the work
        const auto cell = [&](int row, int column) {
            return model.index(row, column).data().toString();
        };
        QCOMPARE(cell(0, 0), QStringLiteral("the wheel: runout or unbalance"));
        QCOMPARE(cell(1, 0), QStringLiteral("fixed to the work: centres, headstock, blank"));

        count.setFocus();
        count.selectAll();
        QTest::keyClicks(&count, QStringLiteral("210"));
        QTest::keyClick(&count, Qt::Key_Return);
        auto& frequencies = *dialog.findChild<QLineEdit*>(QStringLiteral("wavesFrequencies"));
        QTest::keyClicks(&frequencies, QStringLiteral("140,1; 25"));
        QCOMPARE(dialog.causes().size(), waveCauses(letter(), {210, {140.1, 25}}).size());
        QCOMPARE(model.rowCount(), int(dialog.causes().size()));
        QVERIFY(model.rowCount() >= 4);
        QStringList sources;
        for (int row = 0; row < model.rowCount(); ++row) {
            sources << cell(row, 0);
        }
        QVERIFY(sources.contains(QStringLiteral("a known frequency, 140.1 Hz")));
        QVERIFY(sources.contains(QStringLiteral("the wheel, with 3 waves around it")));
        QVERIFY(sources.contains(
            QStringLiteral("chatter at the wheel head’s natural frequency, 140 Hz")));

        QTest::keyClicks(&frequencies, QStringLiteral("; x"));
        const auto& test = *dialog.findChild<QLabel*>(QStringLiteral("waveTest"));
        QVERIFY2(test.text().contains(QStringLiteral("x")), qPrintable(test.text()));
        QCOMPARE(model.rowCount(), int(sources.size())); // nothing is lost
    }

    /// An edit that needs more radii takes them, and one undo brings both back.
    void anEditTakesTheRadiiThatItNeeds() {
        Bench bench(QStringLiteral("en"));
        Document& document = bench.window->document();
        Project project = letter();
        project.machine->work_speed_rpm = 700; // 4 a turn
        project.wheel->runout.emplace().amplitude_um = 0.5;
        project.part->radii_per_section = 48;
        document.edit(project, {"Edit", "Test"});
        ProjectModel model(document);
        const auto speed = [](double value) {
            return [value](void* owner) { static_cast<Machine*>(owner)->work_speed_rpm = value; };
        };
        model.change("/machine/work_speed_rpm", speed(350), false);
        QCOMPARE(document.project().machine->work_speed_rpm, 350.0);
        QCOMPARE(document.project().part->radii_per_section, 96);
        document.undo();
        QCOMPARE(document.project().part->radii_per_section, 48);
        // One form of the runout replaces another.
        project = document.project();
        project.machine->stiffness_n_um.emplace();
        document.edit(project, {"Edit", "Test"});
        const auto grade = [](void* owner) {
            static_cast<WheelRunout*>(owner)->balance_grade_mm_s = 1;
        };
        model.change("/wheel/runout/balance_grade_mm_s", grade, false);
        const WheelRunout& runout = *document.project().wheel->runout;
        QVERIFY(!runout.amplitude_um && runout.balance_grade_mm_s && runout.rotor_mass_kg);
    }

    void theMenuOpensItForTheProject() {
        Bench bench(QStringLiteral("ru"));
        std::vector<WaveCause> causes;
        QTimer::singleShot(0, bench.window.get(), [&] {
            auto* dialog = qobject_cast<WavesDialog*>(QApplication::activeModalWidget());
            causes = dialog ? dialog->causes() : causes;
            QVERIFY(dialog);
            dialog->reject();
        });
        bench.action("countedWaves")->trigger();
        QVERIFY(!causes.empty());
    }
};

} // namespace sparkout::test_waves_dialog

SPARKOUT_TEST(test_waves_dialog, TestWavesDialog)
#include "test_waves_dialog.moc"
