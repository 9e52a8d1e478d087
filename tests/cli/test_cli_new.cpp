// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `new` as a user meets it: the project it writes is the engine's starting cycle, and what it
// refuses.
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/new_project.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <QFile>

#include <string>

namespace test_cli_new {

using namespace sparkout;
using namespace cli;

class TestCliNew : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void writesTheStartingCycleOfTheDrawing() {
        const QString file = m_folder.filePath("seat.sparkout");
        const ProcessOutcome outcome = run({"new", "35k6", "--length", "28", "--stock", "0.15",
                                            "--ra", "0.8", "--machine", "3М153", "-o", file});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QVERIFY(has(outcome.out, "rough depth limited by"));
        QVERIFY(has(outcome.out, "fit for every stock of "));

        auto drawing = *drawingOf(*parseSizeDesignation("35k6"));
        drawing.name = "35k6 × 28";
        drawing.length_mm = 28;
        drawing.stock_mm = 0.15;
        drawing.tolerance.roughness_ra_um = 0.8;
        Issues issues;
        const StartingAnswer answer =
            drawnProject(drawing, *startingEntries({"3М153", {}, {}}, drawing, issues));
        QVERIFY(answer.start->project.optimisation.has_value()); // good for every stock
        QVERIFY(sameProject(projectOf(file), answer.start->project));
        QCOMPARE(run({"simulate", file}).status, 0);
    }

    void whatBoundsTheRoughDepthIsStatedInNumbers() {
        const QString file = m_folder.filePath("coarse.sparkout");
        const ProcessOutcome outcome =
            run({"new", "120e9", "--length", "400", "--stock", "0.2", "-o", file});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QVERIFY(has(outcome.out, "rough depth limited by the depth of the burnt layer: "));
        QVERIFY(has(outcome.out, " µm instead of the usual 15.0 µm\n"));
        QVERIFY(has(outcome.out, "machining time"));
    }

    void boreIsGroundOnTheInternalMachine() {
        const QString file = m_folder.filePath("bore.sparkout");
        const ProcessOutcome outcome =
            run({"new", "60H7", "--length", "70", "--stock", "0.15", "-o", file});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const Project project = projectOf(file);
        QCOMPARE(project.part->surface, Surface::internal);
        QCOMPARE(project.machine->name, std::string("3К227"));
        QVERIFY(project.operation->travels);
        QVERIFY(project.wheel->diameter_mm < 60);
    }

    void operationAndShoulderAreTaken() {
        const QString file = m_folder.filePath("shoulder.sparkout");
        const ProcessOutcome outcome =
            run({"new", "40h6", "--length", "200", "--stock", "0.2", "--operation", "traverse",
                 "--shoulder", "tailstock", "-o", file});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const Project project = projectOf(file);
        QVERIFY(project.operation->travels);
        QCOMPARE(project.machine->overrun_exit_mm, 0.0);
        QVERIFY(project.machine->overrun_entry_mm > 0 && project.machine->dwell_exit_s > 0);
    }

    void aFileThatIsThereIsKeptWithoutForce() {
        const QString file = save(QStringLiteral("kept.sparkout"), "mine");
        QStringList arguments{"new", "35k6", "--length", "28", "--stock", "0.15", "-o", file};
        const ProcessOutcome outcome = run(arguments);
        QCOMPARE(outcome.status, 1);
        QVERIFY(has(outcome.err, "--force"));
        QCOMPARE(samples::readText(file.toStdString()), std::string("mine"));
        QCOMPARE(run(arguments << "--force").status, 0);
        const Project made = projectOf(file);
        QCOMPARE(made.part->diameter_mm, 35.0);
    }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString file = m_folder.filePath("none.sparkout");
        addRow("no size", QStringList{"new"});
        addRow("no field",
               QStringList{"new", "35", "--length", "28", "--stock", "0.1", "-o", file});
        addRow("no stock", QStringList{"new", "35k6", "--length", "28", "-o", file});
        addRow("no file", QStringList{"new", "35k6", "--length", "28", "--stock", "0.1"});
    }

    void usageErrors() {
        QFETCH(QStringList, arguments);
        const ProcessOutcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void whatIsRefusedIsNamedWithWhatIsAllowed_data() {
        addColumns<QStringList, QString, QString>("arguments", "named", "allowed");
        const QStringList size{"--length", "28", "--stock", "0.15"};
        addRow("field", QStringList{"30z6"} + size, QString("30z6"), QString("IT4…IT14"));
        addRow("machine", QStringList{"35k6", "--machine", "3М15"} + size,
               QString("--machine: \"3М15\" fits several: "),
               QString("several: \"3М151\", \"3М151Ф2\", \"3М153\"\n"));
        addRow("no machine", QStringList{"35k6", "--machine", "lathe"} + size, QString("--machine"),
               QString("3М151"));
        addRow("wheel", QStringList{"35k6", "--wheel", "25А"} + size, QString("--wheel"),
               QString("600×63×305"));
        addRow("material", QStringList{"35k6", "--material", "gold"} + size, QString("--material"),
               QString("ШХ15"));
        addRow("room",
               QStringList{"40h6", "--length", "90", "--stock", "0.15", "--shoulder", "both"},
               QString("--length"), QString("126"));
        addRow("wheels for the room",
               QStringList{"40h6", "--length", "90", "--stock", "0.15", "--shoulder", "both"},
               QString("that fit: to traverse 40, 25 mm"), QString("a third"));
        addRow("narrow wheel",
               QStringList{"40h6", "--length", "90", "--stock", "0.15", "--operation", "plunge"},
               QString("--operation traverse, or --wheel: 63 mm does not cover "),
               QString("≥ 90 mm (--length)"));
        addRow("large part", QStringList{"240h6"} + size,
               QString("240h6: 240 mm does not fit the machine; allowed: ≤ 200 mm (--machine)"),
               QString("--machine: \"3М151\" does not accept this part; machines of the catalogue "
                       "that do: \"3У131\", \"3У132\", \"3М131\", \"3М132\", \"3М174\"\n"));
        addRow("long part", QStringList{"40h6", "--length", "800", "--stock", "0.15"},
               QString("--length: 800 mm does not fit the machine; allowed: ≤ 700 mm (--machine)"),
               QString("\"3У132\", \"3М132\", \"3М174\"\n"));
        addRow("bore of the wheel", QStringList{"35k6", "--wheel", "500×50×203 25А F60 K"} + size,
               QString("--wheel: 203 mm does not fit the machine; allowed: 305 mm (--machine)"),
               QString("--wheel: 50 mm does not fit the machine; allowed: 63…100 mm (--machine)"));
        addRow("rounding", QStringList{"6H7", "--length", "10", "--stock", "0.05"},
               QString("--wheel: 20 mm does not fit"), QString("< 5.866 mm"));
    }

    void whatIsRefusedIsNamedWithWhatIsAllowed() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        QFETCH(QString, allowed);
        const QString file = m_folder.filePath("refused.sparkout");
        const ProcessOutcome outcome =
            run(QStringList{"new"} + arguments + QStringList{"-o", file});
        QCOMPARE(outcome.status, 1);
        const QString said = QString::fromStdString(outcome.err);
        QVERIFY2(said.contains(named) && said.contains(allowed), outcome.err.c_str());
        QVERIFY(!QFile::exists(file));
    }
};

} // namespace test_cli_new

SPARKOUT_TEST(test_cli_new, TestCliNew)
#include "test_cli_new.moc"
