// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The form of zones that hold several sections, as a table of the verdict panel.
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/views/requirements/verdict_bench.h"
#include "ui/dialogs/copy_table.h"
#include "ui/results/result_tables.h"
#include "ui/text/names.h"
#include "ui/views/requirements/verdict_sections.h"

#include <QApplication>

#include <cstddef>
#include <variant>

namespace sparkout::test_verdict_form {

using namespace verdict_bench;
using verdict_bench::Bench;

Project several(int sections = 5) {
    Project p = traverseProject();
    p.zone_sections = sections;
    return p;
}

/// In the order of the table.
enum FormRow { roundness, cylindricity, totalRunout, taper, crown, formRows };

QString shown(const ValueModel& model, int row, int zone) {
    return model.index(row, zone).data(Qt::DisplayRole).toString();
}

class TestVerdictForm : public VerdictTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void everyZoneHasItsForm() {
        Project soft = several();
        soft.machine->compliance_mm_per_n = std::monostate{};
        soft.machine->stiffness_n_um = Stiffness{15, 5, 50}; // so that its sections come out unlike
        soft.part->shaft.segments = {{soft.part->length_mm, soft.part->diameter_mm}};
        const OutcomePtr outcome = run(soft);
        Bench bench(outcome);
        const ValueModel& model = *bench.panel.form().model();
        QVERIFY(bench.panel.form().isVisible());
        QCOMPARE(model.columnCount(), 3);
        QCOMPARE(model.rowCount(), 5);
        const QString heads[] = {QStringLiteral("RZ1"), QStringLiteral("NZ"),
                                 QStringLiteral("RZ2")};
        for (int zone = 0; zone < 3; ++zone) {
            QCOMPARE(model.headerData(zone, Qt::Horizontal, Qt::DisplayRole).toString(),
                     heads[zone]);
            const auto i = static_cast<std::size_t>(zone);
            const ZoneForm& form = outcome->accuracy.zones.at(i);
            const double roundness_mm = outcome->accuracy.sections.at(i).minimumZone.deviation();
            const auto um = [](double value_mm) { return value_mm * units::umPerMm; };
            QVERIFY(form.cylindricity_mm > 0);
            // What the machine adds is not known.
            QCOMPARE(shown(model, roundness, zone), Names::formAmount(um(roundness_mm), false));
            QCOMPARE(shown(model, cylindricity, zone),
                     Names::formAmount(um(form.cylindricity_mm), false));
            QCOMPARE(shown(model, totalRunout, zone),
                     Names::formAmount(um(form.totalRunout_mm), false));
            QCOMPARE(shown(model, taper, zone),
                     Names::signedMicrometres(um(form.profile.taper_mm)));
            QCOMPARE(shown(model, crown, zone),
                     Names::signedMicrometres(um(form.profile.crown_mm)));
        }
        QVERIFY(shown(model, taper, 0) != shown(model, crown, 0));
    }

    /// Zones of one section and sections of a plunge have none.
    void withoutSectionsInZonesThereIsNone() {
        Bench bench(m_traverse);
        QVERIFY(!bench.panel.form().isVisible());
        bench.show(run(several()));
        QVERIFY(bench.panel.form().isVisible());
        bench.show(m_plunge);
        QVERIFY(!bench.panel.form().isVisible());
        QVERIFY(formTable(*m_plunge).rows.empty());
    }

    /// Of strips that stay uncut nothing is known.
    void uncutStripsHaveNoForm() {
        Project p = several();
        p.cycle->stages.back().axial_feed_mm_min =
            1.2 * p.wheel->width_mm * p.machine->work_speed_rpm;
        const OutcomePtr outcome = run(p);
        Bench bench(outcome);
        for (int row = 0; row < formRows; ++row) {
            QCOMPARE(shown(*bench.panel.form().model(), row, 1), QStringLiteral("—"));
        }
        QVERIFY(std::holds_alternative<std::monostate>(formTable(*outcome).rows.at(1).at(1)));
    }

    /// What its menu saves has all digits, a row a zone.
    void itIsSavedWithAllDigits() {
        const OutcomePtr outcome = run(several());
        const CsvTable table = formTable(*outcome);
        QCOMPARE(table.rows.size(), std::size_t{3});
        QCOMPARE(table.header.size(), qsizetype{6});
        for (std::size_t i = 0; i < 3; ++i) {
            const ZoneForm& form = outcome->accuracy.zones.at(i);
            QCOMPARE(std::get<double>(table.rows[i].at(2)), form.cylindricity_mm * units::umPerMm);
            QCOMPARE(std::get<double>(table.rows[i].at(4)), form.profile.taper_mm * units::umPerMm);
        }
    }

    void itIsAsHighAsItsRows() {
        Bench bench(run(several()));
        const NarrowTable& table = *bench.panel.form().table();
        for (int row = 0; row < formRows; ++row) {
            const QRect cell = table.visualRect(table.model()->index(row, 2));
            QVERIFY(table.viewport()->rect().contains(cell));
        }
    }

    void anotherLanguageReachesTheTips() {
        Bench bench(run(several()));
        fixtures::Marking marking;
        QApplication::installTranslator(&marking);
        QTest::qWait(30);
        const ValueModel& model = *bench.panel.form().model();
        for (int row = 0; row < model.rowCount(); ++row) {
            QVERIFY(model.headerData(row, Qt::Vertical, Qt::ToolTipRole).toString().contains(u'«'));
        }
        QApplication::removeTranslator(&marking);
        QTest::qWait(30);
    }
};

} // namespace sparkout::test_verdict_form

SPARKOUT_TEST(test_verdict_form, TestVerdictForm)
#include "test_verdict_form.moc"
