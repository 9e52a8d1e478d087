// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The requirements in the verdict panel: chosen, explained, led to their input.
#include "core/file/project_file.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/profile_series.h"
#include "tests/registry.h"
#include "tests/ui/views/requirements/verdict_bench.h"
#include "ui/results/result_tables.h"
#include "ui/results/verdict_table.h"
#include "ui/text/judgement_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/views/part/profiles_text.h"
#include "ui/views/study/batch_text.h"

#include <QRegularExpression>
#include <QSignalSpy>

#include <cmath>
#include <nlohmann/json.hpp>

namespace sparkout::test_verdict_requirements {

using namespace verdict_bench;
using verdict_bench::Bench;

class TestVerdictRequirements : public VerdictTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void aClickOrEnterOnARequirementTellsWhichItIs() {
        Bench bench(m_traverse, {320, 1400});
        QSignalSpy spy(&bench.panel, &VerdictPanel::requirementActivated);
        CopyTable& table = bench.requirements();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 0));
        QCOMPARE(spy.count(), 0); // the name of a zone
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 6));
        QCOMPARE(spy.count(), 1);
        const auto clicked = spy.takeFirst().at(0).value<ConstraintResult>();
        QCOMPARE(clicked.zone, Zone::nz);
        QCOMPARE(clicked.kind, ConstraintKind::diameterMax);
        QTest::keyClick(&table, Qt::Key_Down);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.takeFirst().at(0).value<ConstraintResult>().kind,
                 ConstraintKind::radialRunout);
    }

    void whatIsNotCheckedIsNamedAndLeadsToItsField() {
        Bench bench(m_traverse, {320, 1400});
        QLabel& off = bench.label("notChecked");
        QVERIFY(off.isVisible());
        QVERIFY2(off.text().contains(QStringLiteral("burn")), qPrintable(off.text()));
        QSignalSpy asked(&bench.panel, &VerdictPanel::pathAsked);
        off.setFocus();
        for (const OffLimit& each : LimitNames::off(m_traverse->result.project)) {
            QTest::keyClick(&off, Qt::Key_Tab);
            QTest::keyClick(&off, Qt::Key_Return);
            QCOMPARE(asked.size(), 1);
            QCOMPARE(asked.takeFirst().first().value<std::string>(), each.path);
        }
        Project whole = traverseProject();
        whole.part->tolerance = {6, 4, 5, 8, 1.25, 3};
        whole.wheel->runout.emplace().amplitude_um = 0.2;
        resolveWaves(whole);
        whole.material->burn_rise_k = 600;
        whole.wheel->grain_surface_energy_j_m2 = whole.wheel->bond_surface_energy_j_m2 = 10;
        whole.wheel->grain_modulus_gpa = whole.wheel->bond_modulus_gpa = 300;
        whole.machine->wheel_drive_kw = 10;
        bench.show(run(whole));
        QVERIFY(off.text().contains(QStringLiteral("work drive")));
        QVERIFY(!off.text().contains(QStringLiteral("burn")));
        whole.machine->work_drive_kw = 1;
        bench.show(run(whole));
        QVERIFY2(off.text().startsWith(QStringLiteral("Machine not known")),
                 qPrintable(off.text()));
        MachineForm& form = whole.machine->form.emplace();
        form.roundness_um = std::vector<double>{1, 1, 1};
        form.runout_um = std::vector<double>{2, 2, 2};
        form.lobes = 3;
        bench.show(run(whole));
        QVERIFY(!off.isVisible());
    }

    /// The end of a machine's range that is nearer, also where the setting is at that very end.
    void theEndOfARangeIsShownWithItsSide_data() {
        addColumns<double, QString>("speed", "text");
        QTest::newRow("below") << 140.0 << QStringLiteral("≥150");
        QTest::newRow("at the bottom") << 150.0 << QStringLiteral("≥150");
        QTest::newRow("near the bottom") << 160.0 << QStringLiteral("≥150");
        QTest::newRow("near the top") << 240.0 << QStringLiteral("≤250");
        QTest::newRow("at the top") << 250.0 << QStringLiteral("≤250");
        QTest::newRow("above") << 260.0 << QStringLiteral("≤250");
    }
    void theEndOfARangeIsShownWithItsSide() {
        QFETCH(double, speed);
        QFETCH(QString, text);
        Project project = traverseProject();
        project.machine->limits.work_speed_rpm = std::vector<double>{150, 250, 1};
        project.machine->work_speed_rpm = speed;
        const OutcomePtr outcome = run(project);
        const auto found = std::ranges::find(outcome->constraints, ConstraintKind::rangeWorkSpeed,
                                             &ConstraintResult::kind);
        QVERIFY(found != outcome->constraints.end());
        QCOMPARE(Names::limit(*found), text);
    }

    void whatFailsIsExplainedWithSharesThatAddUp() {
        Project project = traverseProject();
        project.part->upper_deviation_um = 0;
        project.part->lower_deviation_um = -2;
        const OutcomePtr outcome = run(project);
        const ConstraintResult* worst = verdict::worst(*outcome);
        QVERIFY(worst && !worst->holds);
        Bench bench(outcome);
        const QString text = bench.label("why").text();
        QVERIFY2(text.contains(Names::signedMicrometres(worst->value)), qPrintable(text));
        // "…: gauge +a µm; zone +b µm (…); out of round +c µm."
        static const QRegularExpression share(QStringLiteral("([+−-]?[0-9.]+)\u00a0µm"));
        QList<double> numbers;
        auto found = share.globalMatch(text);
        while (found.hasNext()) {
            numbers << found.next().captured(1).replace(u'−', u'-').toDouble();
        }
        QCOMPARE(numbers.size(), 4);
        QVERIFY(std::abs(numbers[1] + numbers[2] + numbers[3] - numbers[0]) < 0.03); // of 0.01 each
    }

    void aSettingIsSetWhereItsRequirementLeads() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            Project project =
                operation == Operation::traverse ? traverseProject() : plungeProject(3);
            project.machine->limits.radial_feed_mm = std::vector<double>{0, 1, 0.001};
            project.machine->limits.axial_feed_mm_min = std::vector<double>{0, 1e4, 1};
            project.machine->limits.plunge_feed_mm_min = std::vector<double>{0, 10, 0.01};
            project.machine->limits.work_speed_rpm = std::vector<double>{10, 1000, 1};
            const OutcomePtr outcome = run(project);
            QVERIFY(outcome->ran());
            const auto file = nlohmann::json::parse(writeProject(project));
            int settings = 0;
            for (const ConstraintResult& c : outcome->constraints) {
                const std::string path = verdict::inputPath(c);
                QCOMPARE(!path.empty(), requirementOf(c.kind).scope == ConstraintScope::setting);
                if (path.empty() || c.kind == ConstraintKind::gaugeCommands
                    || c.kind == ConstraintKind::overlap) {
                    continue; // its value is what the stages need, or follows from the feed
                }
                const nlohmann::json::json_pointer pointer(path);
                QVERIFY2(file.contains(pointer), path.c_str());
                QCOMPARE(file.at(pointer).get<double>(), c.value);
                ++settings;
            }
            QVERIFY(settings >= 3);
        }
    }

    // What practice requires has a row each, with its least, and a way to the feed or stock.
    void limitsOfPracticeAreShownWithTheirLeast() {
        Project project = traverseProject();
        const double turns = project.wheel->width_mm * project.machine->work_speed_rpm;
        project.part->upper_deviation_um = 900;
        project.part->lower_deviation_um = -900;
        project.cycle->stages.back().axial_feed_mm_min = turns / 1.5;
        project.least_overlap = 1.05;
        project.least_overlap_last = 2;
        project.least_steps = 1;
        const OutcomePtr outcome = run(project);
        QCOMPARE(verdict::worst(*outcome)->kind, ConstraintKind::leastOverlapLast);
        const QString text = JudgementText::headline(judge(outcome->result, outcome->constraints));
        QVERIFY2(text.contains(
                     QStringLiteral("overlap B/s in the last stage is 1.5, 0.5 below the minimum")),
                 qPrintable(text));
        QVERIFY(
            verdict::why(*outcome, *verdict::worst(*outcome))
                .contains(QStringLiteral("2 is reached at ") + Names::significant(turns / 2, 4)));
        const std::string last = std::to_string(project.cycle->stages.size() - 1);
        QCOMPARE(verdict::inputPath(*verdict::worst(*outcome)),
                 "/cycle/stages/" + last + "/axial_feed_mm_min");
        const ValueTable table = verdictTable(outcome.get(), {});
        const auto constraints = verdictRows(*outcome);
        QStringList limits;
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const ConstraintResult* c = constraints[row];
            if (c && c->kind >= ConstraintKind::overlap) {
                limits << table.cells[row][std::size_t(VerdictColumn::limit)].text;
                QCOMPARE(c->kind == ConstraintKind::leastSteps,
                         verdict::inputPath(*c).ends_with("stock_mm"));
            }
        }
        QStringList expected(static_cast<qsizetype>(project.cycle->stages.size()) - 1,
                             QStringLiteral("≥1.05"));
        expected << QStringLiteral("≥2") << QStringLiteral("≥1");
        QCOMPARE(limits, expected);
    }

    // Where strips stay uncut, the verdict says so, and no number stands for the surface.
    void stripsAreSaidAndTheSurfaceHasNoNumbers() {
        Project project = traverseProject();
        project.part->upper_deviation_um = 900;
        project.part->lower_deviation_um = -900;
        project.cycle->stages.front().axial_feed_mm_min =
            1.25 * project.wheel->width_mm * project.machine->work_speed_rpm;
        const OutcomePtr outcome = run(project);
        QVERIFY(outcome->ran());
        QCOMPARE(verdict::worst(*outcome)->kind, ConstraintKind::overlap);
        const Judgement judgement = judge(outcome->result, outcome->constraints);
        QCOMPARE(judgement.state, JudgedState::fails);
        const QString text = JudgementText::headline(judgement);
        QVERIFY2(text.contains(QStringLiteral("overlap B/s in stage 1 is 0.8, below 1: strips")),
                 qPrintable(text));
        const ValueTable table = verdictTable(outcome.get(), {});
        const auto constraints = verdictRows(*outcome);
        int surface = 0;
        for (std::size_t line = 0; line < table.rows.size(); ++line) {
            const ConstraintResult* c = constraints[line];
            if (!c) {
                continue;
            }
            const auto shown = [&](VerdictColumn column) {
                return table.cells[line][std::size_t(column)].text;
            };
            const bool dash = shown(VerdictColumn::value) == QStringLiteral("–")
                              && shown(VerdictColumn::margin) == QStringLiteral("–");
            QCOMPARE(dash, !c->isWhole);
            QCOMPARE(shown(VerdictColumn::requirement).contains(QStringLiteral("strips uncut")),
                     !c->isWhole);
            surface += c->isWhole ? 0 : 1;
        }
        QVERIFY(surface >= 9); // three zones
        for (const std::vector<CsvCell>& row : zoneTable(*outcome).rows) {
            for (std::size_t column = 3; column <= 7; ++column) { // sizes, runout, roundness
                QVERIFY(std::holds_alternative<std::monostate>(row.at(column)));
            }
            QVERIFY(std::holds_alternative<double>(row.at(8))); // the force
            QVERIFY(row.size() == 9 || std::holds_alternative<std::monostate>(row.at(9)));
        }
        const ProfileSeries series = makeProfileSeries(outcome->result, outcome->trajectory);
        for (const Profile& profile : series.profiles) {
            QVERIFY(ProfilesText::numbers(series, profile, false)
                        .contains(QStringLiteral("size and form are not known")));
        }
        BatchSummary batch;
        batch.parts = 10;
        batch.stripped = 3;
        QVERIFY(BatchText::counts(batch).contains(
            QStringLiteral("3 of 10 parts have no size, form and Ra")));
    }

    void aRowThatHoldsIsExplainedWhenChosen() {
        Project project = traverseProject();
        project.part->upper_deviation_um = 100;
        project.part->lower_deviation_um = -100;
        project.part->tolerance.radial_runout_um = 100;
        Bench bench(run(project), {320, 1400});
        QVERIFY(bench.label("why").text().isEmpty());
        CopyTable& table = bench.requirements();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 3));
        const QString text = bench.label("why").text();
        QVERIFY2(text.contains(QStringLiteral("Radial runout")), qPrintable(text));
        QVERIFY(text.contains(Names::micrometres(project.part->initial_runout_mm * 1e3)));
    }

    void refusedTextsInTheInputsAreSaid() {
        Bench bench(m_traverse);
        QLabel& notice = bench.label("refusedFields");
        QVERIFY(!notice.isVisible());
        bench.panel.setRefusedFields(2);
        QVERIFY(notice.isVisible() && isInSight(notice, bench.panel));
        QCOMPARE(notice.text(), QStringLiteral("2 fields contain invalid entries; the verdict is "
                                               "based on their last valid values."));
        bench.show(m_plunge); // a newer run of the values before it says nothing else
        QVERIFY(notice.isVisible());
        bench.panel.setRefusedFields(0);
        QVERIFY(!notice.isVisible());
    }
};

} // namespace sparkout::test_verdict_requirements

SPARKOUT_TEST(test_verdict_requirements, TestVerdictRequirements)
#include "test_verdict_requirements.moc"
