// SPDX-License-Identifier: GPL-3.0-or-later
// Which force law a recorded spark-out supports [MODEL-13], and the numbers of the law with a
// threshold found from recorded cycles.
#include "core/measured/calibration.h"
#include "core/measured/force_law_choice.h"
#include "core/measured/identification.h"
#include "core/process/compliance.h"

#include "tests/core/measured/measured_cycles.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_force_law_choice {

using fixtures::close;
using measured_cycles::record;
using measured_cycles::trace;
using measured_cycles::yieldingPlunge;

/// The plunge of the model page's example, which ends with a spark-out of so many revolutions.
Project sparkingOut(ForceLawKind law, int revolutions) {
    Project p = fixtures::plunge();
    p.part->diameter_mm = 40;
    p.wheel->diameter_mm = 500;
    p.machine->work_speed_rpm = 160;
    p.machine->wheel_speed_m_s = 30;
    p.machine->compliance_mm_per_n = std::vector<double>{8e-5};
    p.gauge->control = Control::position;
    p.part->stock_mm = 0.2;
    p.material->force_law = law;
    p.material->specific_force_mpa = 50'000;
    p.material->threshold_force_n_mm = 0.8;
    p.cycle->stages = {fixtures::plungeStage(0.6, 0.2),
                       fixtures::sparkStage(fixtures::count(revolutions))};
    return p;
}

/// The diameter over the spark-out as a gauge reads it, ten times a second.
SparkOutRecord recorded(const Project& p, double noise_mm, std::uint32_t seed) {
    const measured_cycles::Record cycle = record(p);
    const MeasuredTrace whole =
        trace(TraceQuantity::gauge_size, cycle, {.noise = noise_mm, .seed = seed});
    SparkOutRecord out{60 / p.machine->work_speed_rpm, {}, {}};
    const auto revolutions = static_cast<std::size_t>(p.cycle->stages.back().spark_out.count);
    const double from_s = cycle.end_s[cycle.end_s.size() - 1 - revolutions];
    const std::vector<double>&times = whole.time_s.values(), &values = whole.values.values();
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] >= from_s) {
            out.time_s.push_back(times[i] - from_s);
            out.size_mm.push_back(values[i]);
        }
    }
    return out;
}

FittedParameter of(FittedKind kind) {
    return {kind, {}, {}};
}

double valueOf(const Identification& found, FittedKind kind) {
    for (const FittedValue& value : found.values) {
        if (value.parameter.kind == kind) {
            return value.value;
        }
    }
    return 0;
}

class TestForceLawChoice : public QObject {
    Q_OBJECT

private slots:
    // Without noise each law leaves next to nothing of its own record, and far more of the other's.
    void eachLawIsKnownByItsSparkOut() {
        const Project threshold = sparkingOut(ForceLawKind::threshold, 24);
        const auto one = chooseForceLaw(threshold, recorded(threshold, 0, 1));
        QVERIFY(one.has_value());
        QCOMPARE(one->supported, SupportedLaw::threshold);
        QCOMPARE(one->revolutions, 24);
        QVERIFY2(one->thresholdRms_um < 1e-5, qPrintable(QString::number(one->thresholdRms_um)));
        QVERIFY(one->sourcesRms_um > 1e3 * one->thresholdRms_um);
        const double x = 8e-5 * 40 * 50'000 * std::numbers::pi * 40 * 160 / (30 * 60e3);
        const double tau_s = -60.0 / 160 / std::log(x / (1 + x));
        QVERIFY2(close(one->timeConstant_s, tau_s, 1e-4),
                 qPrintable(QStringLiteral("%1 %2").arg(one->timeConstant_s).arg(tau_s)));

        const Project sources = sparkingOut(ForceLawKind::sources, 24);
        const auto other = chooseForceLaw(sources, recorded(sources, 0, 1));
        QVERIFY(other.has_value());
        QCOMPARE(other->supported, SupportedLaw::sources);
        // the two radii of a diameter do not lag alike, and of this law they do not fall alike
        QVERIFY2(other->sourcesRms_um < 0.02, qPrintable(QString::number(other->sourcesRms_um)));
        QVERIFY(other->thresholdRms_um > 10 * other->sourcesRms_um);
    }

    // With the noise of a gauge, 0.1 µm, the right law is nearly always supported and the wrong one
    // hardly ever.
    void noiseLeavesTheRightLaw() {
        for (const ForceLawKind law : {ForceLawKind::sources, ForceLawKind::threshold}) {
            const Project p = sparkingOut(law, 24);
            const SupportedLaw right =
                law == ForceLawKind::sources ? SupportedLaw::sources : SupportedLaw::threshold;
            int supported = 0, wrong = 0;
            constexpr int trials = 10;
            for (std::uint32_t seed = 1; seed <= trials; ++seed) {
                const auto found = chooseForceLaw(p, recorded(p, 1e-4, seed));
                QVERIFY(found.has_value());
                supported += found->supported == right;
                wrong += found->supported != right && found->supported != SupportedLaw::undecided;
                QCOMPARE(found->revolutionsMore.has_value()
                             && found->supported != SupportedLaw::undecided,
                         false);
            }
            QVERIFY2(supported >= trials - 2 && wrong <= 1,
                     qPrintable(QStringLiteral("%1 %2").arg(supported).arg(wrong)));
        }
    }

    // A spark-out that is too short says how much longer it had to be; that long, it decides.
    void aShortSparkOutSaysHowManyRevolutionsMore() {
        constexpr double noise_mm = 4e-4;
        int asked = 0, decided = 0;
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            const Project p = sparkingOut(ForceLawKind::sources, 5);
            const auto found = chooseForceLaw(p, recorded(p, noise_mm, seed));
            QVERIFY(found.has_value());
            if (found->supported != SupportedLaw::undecided || !found->revolutionsMore) {
                continue;
            }
            ++asked;
            QVERIFY(*found->revolutionsMore >= 1 && *found->revolutionsMore <= 500);
            const Project longer =
                sparkingOut(ForceLawKind::sources, 5 + 2 * *found->revolutionsMore);
            const auto then = chooseForceLaw(longer, recorded(longer, noise_mm, seed + 100));
            QVERIFY(then.has_value());
            decided += then->supported == SupportedLaw::sources;
        }
        QVERIFY2(asked >= 4, qPrintable(QString::number(asked)));
        QVERIFY2(decided >= asked * 2 / 3,
                 qPrintable(QStringLiteral("%1 of %2").arg(decided).arg(asked)));
    }

    void tooLittleSaysNothing() {
        const Project p = sparkingOut(ForceLawKind::threshold, 24);
        SparkOutRecord whole = recorded(p, 0, 1);
        SparkOutRecord shorter = whole;
        const auto left = static_cast<std::size_t>(
            std::ranges::lower_bound(whole.time_s, 3.5 * whole.revolution_s)
            - whole.time_s.begin());
        shorter.time_s.resize(left);
        shorter.size_mm.resize(left);
        QVERIFY(!chooseForceLaw(p, shorter));
        std::ranges::fill(whole.size_mm, 0.5);
        QVERIFY(!chooseForceLaw(p, whole));
        QVERIFY(!sparkOutOf(fixtures::plunge(), {40}, 0));       // no spark-out
        QVERIFY(!sparkOutOf(fixtures::traverse(), {20, 30}, 0)); // no plunge
    }

    // α and β of the fit are the factors of K and F'_0, in the balance and in the force.
    void theNumbersOfTheThresholdAreFound() {
        Project project = yieldingPlunge();
        project.material->burn_rise_k.reset();
        project.material->force_law = ForceLawKind::threshold;
        project.material->specific_force_mpa = 20'000;
        project.material->threshold_force_n_mm = 0.5;
        Project truth = project;
        truth.material->specific_force_mpa *= 1.3;
        truth.material->threshold_force_n_mm *= 0.8;
        scaleCompliance(truth, 0.9);
        const measured_cycles::Record cycle = record(truth);
        project.measured.emplace().traces = {trace(TraceQuantity::gauge_size, cycle, {}),
                                             trace(TraceQuantity::normal_force, cycle, {})};
        const Identification found =
            identify(project, {.parameters = {of(FittedKind::alpha), of(FittedKind::beta),
                                              of(FittedKind::compliance)}});
        QCOMPARE(found.status, IdentificationStatus::fitted);
        QVERIFY(close(valueOf(found, FittedKind::alpha), 1.3, 1e-6));
        QVERIFY(close(valueOf(found, FittedKind::beta), 0.8, 1e-6));
        QVERIFY(close(valueOf(found, FittedKind::compliance), 0.9, 1e-6));
        const Project made = withCalibration(project, found, "test.csv", "2026-03-04");
        QVERIFY(close(made.material->specific_force_mpa, 26'000, 1e-6));
        QVERIFY(close(made.material->threshold_force_n_mm, 0.4, 1e-6));
        QCOMPARE(simulate(made).countsByStage, simulate(truth).countsByStage);
        for (const FittedKind kind : {FittedKind::flow_stress, FittedKind::dullness}) {
            QCOMPARE(identify(project, {.parameters = {of(kind)}}).status,
                     IdentificationStatus::notApplicable);
        }
    }

    void aFitSaysWhatItsSparkOutSupports() {
        Project project = sparkingOut(ForceLawKind::threshold, 24);
        const measured_cycles::Record cycle = record(project);
        project.measured.emplace().traces = {
            trace(TraceQuantity::gauge_size, cycle, {.noise = 1e-4})};
        const Identification found =
            identify(project, {.parameters = {of(FittedKind::alpha), of(FittedKind::size_offset)}});
        QVERIFY(found.forceLaw.has_value());
        QCOMPARE(found.forceLaw->supported, SupportedLaw::threshold);
        QCOMPARE(found.forceLaw->revolutions, 24);
    }
};

} // namespace sparkout::test_force_law_choice

SPARKOUT_TEST(test_force_law_choice, TestForceLawChoice)
#include "test_force_law_choice.moc"
