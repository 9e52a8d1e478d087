// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel's factor of Ra and its strengths from measurements.
#include "core/measured/wheel_calibration.h"
#include "tests/whole_project.h"

#include "core/process/force.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>

namespace sparkout::test_wheel_calibration {

Project plunge() {
    Project project = samples::project("smallest-plunge");
    project.part->tolerance.roughness_ra_um = 50;
    project.wheel->marking = "25А F60 L 6 V";
    project.wheel->dressing = "0.02 mm";
    return project;
}

/// The greatest Ra that the project's cycle leaves [µm].
double roughnessOf(const Project& project) {
    double most = 0;
    for (const ConstraintResult& constraint : evaluateConstraints(simulate(project))) {
        most =
            constraint.kind == ConstraintKind::roughness ? std::max(most, constraint.value) : most;
    }
    return most;
}

Project withStrengthsGiven() {
    Project project = plunge();
    project.wheel->grain_surface_energy_j_m2 = 20;
    project.wheel->grain_modulus_gpa = 400;
    project.wheel->bond_surface_energy_j_m2 = 10;
    project.wheel->bond_modulus_gpa = 60;
    return project;
}

class TestWheelCalibration : public QObject {
    Q_OBJECT

private slots:
    void theFactorMakesTheComputedRaTheMeasuredOne() {
        Project project = plunge();
        project.wheel->roughness_factor = 1;
        const double computed = roughnessOf(project) / roughnessFactor(project).least;
        QVERIFY(computed > 0);
        QVERIFY(!isRoughnessCalibrated(project));
        // Two parts that are 3 and 12 times as rough: 6 times in the geometric mean.
        project.measured.emplace().parts.resize(3);
        for (MeasuredPart& part : project.measured->parts) {
            part.place = 1;
        }
        project.measured->parts[0].roughness_ra_um = 3 * computed;
        project.measured->parts[2].roughness_ra_um = 12 * computed;
        project.wheel->roughness_factor = 2.5; // what it was before does not count
        const auto found = roughnessFromParts(project);
        QVERIFY(found);
        // All sections of these cuts have nearly the same last cut.
        QVERIFY2(std::abs(found->factor - 6) < 0.3, qPrintable(QString::number(found->factor)));
        QCOMPARE(found->count, std::size_t{2});
        QCOMPARE(found->wheel, std::string("25А F60 L 6 V"));
        QCOMPARE(found->dressing, std::string("0.02 mm"));
        QVERIFY(found->interval95 && found->interval95->low < 6 && found->interval95->high > 6);
        const Project made = withRoughness(project, *found, "parts 1 and 3", "2026-03-04");
        QVERIFY(!hasErrors(validate(made)) && isRoughnessCalibrated(made));
        QVERIFY(std::abs(roughnessOf(made) - found->factor * computed) < 1e-9 * computed);
        const Calibration& calibration = made.measured->calibrations.front();
        QCOMPARE(calibration.input, std::string("/wheel/roughness_factor"));
        QCOMPARE(calibration.count, 2);
        QCOMPARE(calibration.value, found->factor);
    }

    void aFactorOfOneThatIsMeasuredIsCalibrated() {
        Project project = plunge();
        project.wheel->roughness_factor = 1;
        QVERIFY(!isRoughnessCalibrated(project));
        QVERIFY(isRoughnessCalibrated(withRoughness(project, {}, "part 1", "2026-03-04")));
    }

    void noMeasuredRoughnessIsNoFactor() {
        Project project = plunge();
        QVERIFY(!roughnessFromParts(project));
        project.measured.emplace().parts.resize(1);
        QVERIFY(!roughnessFromParts(project));
        project.measured->parts[0].roughness_ra_um = 0.5;
        project.measured->parts[0].place = 150;
        QVERIFY(!roughnessFromParts(project));
    }

    void statisticsOfPartsAreEnough() {
        Project project = plunge();
        MeasuredSummary summary;
        summary.quantity = MeasuredQuantity::roughness_ra;
        summary.count = 25;
        summary.mean_um = 4 * roughnessOf(project) / roughnessFactor(project).least;
        project.measured.emplace().summaries = {summary};
        const auto found = roughnessFromParts(project);
        QVERIFY(found && std::abs(found->factor - 4) < 0.2);
        QCOMPARE(found->count, std::size_t{25});
        QVERIFY(!found->interval95);
    }

    /// With the factor the limit is that very cut, by force or by power.
    void theLimitIsTheMeasuredCut_data() {
        QTest::addColumn<bool>("isForce");
        QTest::newRow("force") << true;
        QTest::newRow("power") << false;
    }
    void theLimitIsTheMeasuredCut() {
        QFETCH(bool, isForce);
        const Project project = withStrengthsGiven();
        constexpr double depth_mm = 0.004, width_mm = 40;
        const ForceLaw law = forceLaw(project);
        const double reading = isForce ? law.normal(width_mm, std::sqrt(depth_mm))
                                       : law.tangential(width_mm, std::sqrt(depth_mm))
                                             * project.machine->wheel_speed_m_s / 1000;
        const auto found = strengthsFromLimit(
            project, isForce ? LimitReading::normal_force : LimitReading::wheel_power, reading,
            width_mm);
        QVERIFY(found);
        QVERIFY(std::abs(found->depth_mm - depth_mm) < 1e-12);
        const Project made = withStrengths(project, *found, "force", "2026-03-04");
        QVERIFY(std::abs(*selfSharpening(made)->limitDepth() - depth_mm) < 1e-9);
        QVERIFY(std::abs(selfSharpening(made)->load(depth_mm) - 1) < 1e-9);
        QCOMPARE(made.measured->calibrations.size(), std::size_t{4});
        QVERIFY(std::abs(*made.wheel->grain_modulus_gpa - 400 * found->factor) < 1e-9);
    }

    void withoutStrengthsThereIsNoFactor() {
        QVERIFY(!strengthsFromLimit(plunge(), LimitReading::normal_force, 100, 40));
        QVERIFY(!strengthsFromLimit(withStrengthsGiven(), LimitReading::normal_force, 0, 40));
        QVERIFY(!strengthsFromLimit(withStrengthsGiven(), LimitReading::wheel_power, 1, 0));
    }
};

} // namespace sparkout::test_wheel_calibration

SPARKOUT_TEST(test_wheel_calibration, TestWheelCalibration)
#include "test_wheel_calibration.moc"
