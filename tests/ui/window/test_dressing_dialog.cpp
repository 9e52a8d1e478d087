// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The parts between dressings in the window: what it says is what the engine finds.
#include "core/setup/dressing_interval.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/setup_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/text/dressing_text.h"
#include "ui/window/dialogs/dressing_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QTemporaryDir>

namespace sparkout::test_dressing_dialog {

/// A plunge that its drive's limit ends after some parts.
Setup dullingPlunge() {
    Project project = fixtures::plunge();
    project.part->upper_deviation_um = 100;
    project.part->lower_deviation_um = -100;
    project.machine->wheel_drive_kw = 3.5;
    Setup setup = plainSetup(project);
    setup.wear.dulling_per_mm2 = 1e-4;
    return setup;
}

QLabel& resultOf(DressingDialog& dialog) {
    return *dialog.findChild<QLabel*>(QStringLiteral("dressingResult"));
}

class TestDressingDialog : public QObject {
    Q_OBJECT

private slots:
    void itSaysWhatTheEngineFinds() {
        Setup setup = dullingPlunge();
        Cost cost;
        cost.machine_per_h = 1800;
        cost.dressing_s = 60;
        cost.dressing_cost = 5;
        setup.surfaces[0].project.optimisation = Optimisation{};
        setup.surfaces[0].project.optimisation->cost = cost;
        const DressingInterval found = dressingInterval(setup);
        QVERIFY(found.parts > 1 && found.end);
        DressingDialog dialog(setup, nullptr);
        dialog.find();
        QCOMPARE(dialog.interval().parts, found.parts);
        const QString text = resultOf(dialog).text();
        for (const auto& [name, value] : DressingText::facts(setup, found)) {
            QVERIFY2(text.contains(value.toHtmlEscaped()), qPrintable(value));
        }
        QCOMPARE(DressingText::facts(setup, found).size(), std::size_t{5});
        QVERIFY(text.contains(QStringLiteral("<b>%1</b>").arg(found.parts)));
        QVERIFY(!dialog.findChild<QComboBox*>()->isEnabled());
    }

    void theBatchesAreChosen() {
        Setup setup = dullingPlunge();
        Batch batch;
        Factor stock;
        stock.uniform = std::vector<double>{0.19, 0.21};
        batch.factors.stock_mm = stock;
        setup.surfaces[0].project.batch = batch;
        DressingDialog dialog(setup, nullptr);
        dialog.find();
        const std::int64_t alone = dialog.interval().parts;
        auto* cases = dialog.findChild<QComboBox*>();
        QVERIFY(cases->isEnabled());
        cases->setCurrentIndex(1);
        emit cases->activated(1);
        DressingOptions options;
        options.scenarios = Scenarios::corners;
        QCOMPARE(dialog.interval().parts, dressingInterval(setup, options).parts);
        QVERIFY(dialog.interval().parts <= alone);
    }

    void withoutWearItLeadsThere() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("sharp.sparkout"));
        Setup setup = dullingPlunge();
        setup.wear = {};
        setup_fixtures::writeSetupFile(setup, path);
        OpenBench bench(QStringLiteral("en"), path);
        QString said;
        int times = 0;
        DialogAnswers answers(
            {QStringLiteral("wheelWear"), QStringLiteral("Escape"), QStringLiteral("Escape")});
        answers.seen = [&](QDialog& dialog) {
            if (auto* dressing = qobject_cast<DressingDialog*>(&dialog)) {
                dressing->find();
                said = resultOf(*dressing).text();
            } else {
                ++times;
            }
        };
        bench.action("dressing")->trigger();
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
        QCOMPARE(times, 1);
        QVERIFY2(said.contains(QStringLiteral("not given")), qPrintable(said));
    }
};

} // namespace sparkout::test_dressing_dialog

SPARKOUT_TEST(test_dressing_dialog, TestDressingDialog)
#include "test_dressing_dialog.moc"
