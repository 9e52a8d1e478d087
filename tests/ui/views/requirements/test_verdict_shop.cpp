// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The shop's numbers in the verdict panel: stage by stage, marked, explained.
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/views/requirements/verdict_bench.h"
#include "ui/text/field_text.h"
#include "ui/text/number_text.h"

#include <QApplication>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace sparkout::test_verdict_shop {

using namespace verdict_bench;
using verdict_bench::Bench;

class TestVerdictShop : public VerdictTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void aColumnAStageAndOneForTheCycle() {
        Bench bench(m_traverse);
        const ShopNumbers& shop = m_traverse->shop;
        QCOMPARE(bench.model().columnCount(), 3);
        const auto head = [&](int column) {
            return bench.model().headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        };
        QCOMPARE(head(0) + head(1) + head(2), QStringLiteral("12Cycle"));
        const TimeUnit unit(shop.cycle.time_s);
        for (int column = 0; column < 3; ++column) {
            const ShopColumn& c = column < 2 ? shop.stages[std::size_t(column)] : shop.cycle;
            const std::pair<const char*, double> numbers[] = {
                {"grinding_time_min", unit.of(c.time_s)},
                {"removal_rate_mm3_mm_s", c.removalRate_mm2_s},
                {"mean_removal_rate_mm3_mm_s", c.meanRemovalRate_mm2_s},
                {"equivalent_chip_um", c.equivalentChip_um},
                {"aggressiveness", c.aggressiveness},
                {"overlap_ratio", *c.overlap},
                {"specific_energy_j_mm3", *c.energy_j_mm3},
                {"peak_power_w", c.power_w.value / 1000},
                {"mean_power_w", c.meanPower_w / 1000},
                {"peak_normal_force_n", c.normalForce_n.value}};
            QCOMPARE(bench.cell("", column).toInt(), c.count);
            for (const auto& [row, value] : numbers) {
                const double shown = bench.cell(row, column).toDouble();
                QVERIFY2(std::abs(shown - value) <= std::max(0.005 * value, 0.0005),
                         qPrintable(bench.cell(row, column, Qt::AccessibleTextRole)));
            }
        }
        QCOMPARE(bench.cell("rotation_ratio", 0), QString());
        QCOMPARE(bench.cell("rotation_ratio", 2).toDouble(), 6.37);
    }

    /// Below two minutes a stage's time is in seconds, by the whole cycle for all of a row.
    void timesAreInTheUnitOfTheCycle() {
        for (const auto& [outcome, name] :
             {std::pair(m_traverse, "traverse"), std::pair(m_plunge, "plunge")}) {
            Bench bench(outcome);
            const int row = bench.row("grinding_time_min");
            const QString head =
                bench.model().headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
            const double cycle_s = outcome->shop.cycle.time_s;
            QVERIFY2(head.endsWith(cycle_s < 120 ? QStringLiteral(", s") : QStringLiteral(", min")),
                     name);
            const double shown = bench.cell("grinding_time_min", 2).toDouble();
            QVERIFY2(std::abs(shown - (cycle_s < 120 ? cycle_s : cycle_s / 60)) < 0.005 * shown,
                     name);
        }
    }

    void plungeHasNoOverlap() {
        Bench bench(m_plunge);
        QCOMPARE(bench.row("overlap_ratio"), -1);
        QVERIFY(bench.row("specific_energy_j_mm3") > 0);
        const auto first = bench.model().headerData(0, Qt::Vertical, Qt::DisplayRole).toString();
        QCOMPARE(first, QStringLiteral("Revolutions"));
        bench.show(m_traverse);
        QVERIFY(bench.row("overlap_ratio") > 0);
    }

    void numbersKeepThreeDigitsAndNeverVanish_data() {
        addColumns<double, QString>("value", "shown");
        QTest::newRow("nothing") << 0.0 << QStringLiteral("0");
        QTest::newRow("hardly anything") << 0.00004321 << QStringLiteral("0.00004");
        QTest::newRow("small") << 0.024172 << QStringLiteral("0.024");
        QTest::newRow("below one") << 0.7265 << QStringLiteral("0.727");
        QTest::newRow("one") << 1.0 << QStringLiteral("1.00");
        QTest::newRow("tens") << 67.35 << QStringLiteral("67.3");
        QTest::newRow("thousands") << 3281.4 << QStringLiteral("3281");
    }

    void numbersKeepThreeDigitsAndNeverVanish() {
        QFETCH(double, value);
        QFETCH(QString, shown);
        QCOMPARE(threeDigits(value), shown);
    }

    void tipsGiveFormulaMeaningAndPlace() {
        Bench bench(m_traverse);
        const QString energy = bench.cell("specific_energy_j_mm3", 0, Qt::ToolTipRole);
        QVERIFY(energy.contains(QStringLiteral("20…120")));
        QVERIFY(energy.contains(QStringLiteral("∫P<sub>z</sub>·V<sub>k</sub> dt")));
        QVERIFY(energy.contains(QStringLiteral(" kJ for "))); // what it is made of
        const QString power = bench.cell("peak_power_w", 0, Qt::ToolTipRole);
        QVERIFY(power.contains(QStringLiteral("RZ1, plunge-in (E1), stage 1, double stroke")));
        for (int row = 0; row < bench.model().rowCount(); ++row) {
            const QString tip =
                bench.model().headerData(row, Qt::Vertical, Qt::ToolTipRole).toString();
            QVERIFY(tip.startsWith(QStringLiteral("<p>"))); // or it would not wrap
        }
    }

    void numbersOutsideTheirBandCarryAnIconAndWords() {
        Project p = traverseProject();
        p.wheel->dullness = 0; // the shear alone, 5.6 J/mm³
        p.cycle->stages[1].axial_feed_mm_min = 1.2 * p.wheel->width_mm * p.machine->work_speed_rpm;
        Bench bench(run(p));
        for (int column = 0; column < 3; ++column) {
            QVERIFY(bench.marked("specific_energy_j_mm3", column));
            QVERIFY(bench.cell("specific_energy_j_mm3", column, Qt::AccessibleTextRole)
                        .endsWith(QStringLiteral("5.60; below the usual")));
            QVERIFY(!bench.marked("peak_power_w", column));
        }
        QVERIFY(!bench.marked("overlap_ratio", 0));
        QVERIFY(bench.marked("overlap_ratio", 1));
        const QString remarks = bench.label("shopRemarks").text();
        QVERIFY(bench.label("shopRemarks").isVisible());
        QVERIFY(remarks.contains(QStringLiteral("below 20 J/mm³ (stage 1, 2)")));
        QVERIFY(remarks.contains(QStringLiteral("Overlap below 1 (stage 2)")));
        bench.show(m_traverse);
        QVERIFY(!bench.label("shopRemarks").isVisible());
        QVERIFY(!bench.marked("specific_energy_j_mm3", 0));
    }

    void wholeRotationRatioIsMarked() {
        Project p = plungeProject(1);
        p.machine->work_speed_rpm =
            p.machine->wheel_speed_m_s * 60e3 / (std::numbers::pi * p.wheel->diameter_mm) / 8;
        Bench bench(run(p));
        QVERIFY(bench.marked("rotation_ratio", 2));
        QVERIFY(!bench.marked("rotation_ratio", 0));
        QVERIFY(bench.label("shopRemarks").text().contains(QStringLiteral("8.00 : 1")));
    }

    void refusedInputsGreyTheNumbers() {
        Bench bench(m_traverse);
        auto refused = std::make_shared<Outcome>();
        refused->issues.push_back({IssueCode::outOfRange, Severity::error, "/wheel/width_mm",
                                   Amount{5000, "mm"}, Bounds{{0.5, 1000}, "mm"}});
        const QString before = bench.cell("specific_energy_j_mm3", 0);
        bench.show(refused);
        QCOMPARE(bench.cell("specific_energy_j_mm3", 0), before);
        QVERIFY(bench.model().index(0, 0).data(Qt::ForegroundRole).isValid());
        bench.show(m_traverse);
        QVERIFY(!bench.model().index(0, 0).data(Qt::ForegroundRole).isValid());
    }

    void anotherLanguageReachesTheTipsOfTheTable() {
        Bench bench(m_traverse);
        fixtures::Marking marking;
        QApplication::installTranslator(&marking);
        QTest::qWait(30);
        const ValueModel& model = bench.model();
        for (int row = 0; row < model.rowCount(); ++row) {
            QVERIFY(model.headerData(row, Qt::Vertical, Qt::ToolTipRole).toString().contains(u'«'));
        }
        QApplication::removeTranslator(&marking);
        QTest::qWait(30);
    }
};

} // namespace sparkout::test_verdict_shop

SPARKOUT_TEST(test_verdict_shop, TestVerdictShop)
#include "test_verdict_shop.moc"
