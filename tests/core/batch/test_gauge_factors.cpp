// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the gauge and the part's temperature as factors of a batch, what the machine prints
// without a form, the usual batch, and what a batch leaves out.
#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"
#include "core/batch/scenario_source.h"
#include "core/batch/usual_batch.h"
#include "core/project/gauge.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sparkout::test_gauge_factors {

using fixtures::normal;
using fixtures::uniform;
using fixtures::within;

Factor growing(double from, double to, int parts) {
    Factor factor;
    factor.grows = {from, to};
    factor.parts_between_dressings = parts;
    return factor;
}

/// A rigid plunge fed 0.05 µm a revolution, whose gauge is known.
Project fineBatch(int parts) {
    Project p = fixtures::stiffBatch(parts);
    p.part->stock_mm = 0.02;
    p.cycle->stages = {fixtures::plungeStage(0.009, 0.02)};
    p.machine->compliance_mm_per_n =
        std::vector<double>(static_cast<std::size_t>(p.sections), 1e-15);
    p.machine->gauge_repeatability_um = 0.8;
    p.machine->gauge_drift_um_h = 1.5;
    return p;
}

std::vector<double> errorsOf(const ScenarioSource& source) {
    std::vector<double> errors;
    for (std::int64_t part = 0; part < source.parts(); ++part) {
        errors.push_back(readsTooLarge_mm(source.project(part)) * 1000);
    }
    return errors;
}

double varianceOf(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double value : values) {
        sum += value;
    }
    const double mean = sum / static_cast<double>(values.size());
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    return squares / static_cast<double>(values.size());
}

bool isNotCounted(const Project& project, FactorKind kind) {
    const std::vector<FactorKind> left = notCounted(project);
    return std::ranges::find(left, kind) != left.end();
}

class TestGaugeFactors : public QObject {
    Q_OBJECT

private slots:
    /// The i-th part stands i pieces after the setting: e = v·t, from the first to the last part
    /// between two settings, then from the start.
    void driftIsLinearInTheNumberOfThePart() {
        Project p = fineBatch(30);
        p.batch->factors.gauge_age_h = growing(0, 0.5, 11);
        const std::vector<double> errors = errorsOf(ScenarioSource(p));
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double expected_um = 1.5 * 0.5 * static_cast<double>(i % 11) / 10;
            QVERIFY(within(errors[i], expected_um, 1e-12));
        }
    }

    /// s² = s_g²·s_z² + α²·d²·s_ΔT², of independent factors, with an error that comes on top.
    void variancesOfIndependentErrorsAdd() {
        Project p = fineBatch(4000);
        p.batch->factors.gauge_error = normal(0, 1);
        p.batch->factors.part_warmer_k = normal(0, 2);
        p.material->expansion_um_m_k = 12;
        p.gauge->error_um = 0.3;
        const double warm_um = 12e-3 * 30 * 2; // µm/(m·K) on 30 mm for 2 K
        const std::vector<double> errors = errorsOf(ScenarioSource(p));
        const double expected = 0.8 * 0.8 + warm_um * warm_um;
        QVERIFY(std::abs(varianceOf(errors) / expected - 1) < 0.05);
        double mean = 0;
        for (const double error : errors) {
            mean += error / static_cast<double>(errors.size());
        }
        QVERIFY(within(mean, 0.3, 0.02));
    }

    /// A factor that multiplies nothing changes no part, and those before it are drawn as ever.
    void withoutTheMachinesNumbersNothingScatters() {
        Project p = fixtures::shaftBatch(12);
        const std::vector<PartRow> before = runBatch(p).statistics.rows;
        p.batch->factors.gauge_error = normal(0, 1);
        p.batch->factors.gauge_age_h = growing(0, 1, 12);
        p.batch->factors.part_warmer_k = uniform(0, 0);
        const BatchResult result = runBatch(p);
        QVERIFY(result.status == BatchStatus::completed);
        QCOMPARE(result.statistics.rows.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(result.statistics.rows[i].values, before[i].values);
        }
        QVERIFY(isNotCounted(p, FactorKind::gaugeError));
        QVERIFY(isNotCounted(p, FactorKind::gaugeAge));
        p.machine->gauge_repeatability_um = 0.5;
        QVERIFY(!isNotCounted(p, FactorKind::gaugeError));
    }

    /// Corners are of the others; an error of the reading stands at its middle.
    void cornersLeaveTheReadingAtItsMiddle() {
        Project p = fineBatch(10);
        p.batch->scenarios = Scenarios::corners;
        p.batch->factors.stock_mm = uniform(0.018, 0.022);
        p.batch->factors.compliance = uniform(0.9, 1.1);
        const std::vector<double> plain = errorsOf(ScenarioSource(p));
        QCOMPARE(plain.size(), std::size_t{4});
        p.batch->factors.gauge_error = normal(0.5, 1);
        p.batch->factors.gauge_age_h = growing(0, 1, 10);
        const ScenarioSource source(p);
        QCOMPARE(source.parts(), std::int64_t{4});
        for (const double error : errorsOf(source)) {
            QVERIFY(within(error, 0.5 * 0.8 + 0.5 * 1.5, 1e-9));
        }
        QVERIFY(isNotCounted(p, FactorKind::gaugeError));
        p.batch->scenarios = Scenarios::random;
        QVERIFY(!isNotCounted(p, FactorKind::gaugeError));
    }

    /// Without a form the factor is on the geometric runout, which adds to every runout.
    void geometricRunoutScatters() {
        Project p = fineBatch(8);
        p.part->tolerance.radial_runout_um = 20;
        p.batch->factors.machine_form = uniform(0.5, 1.5);
        QVERIFY(!checkBatch(p).empty()); // there is none
        p.machine->geometric_runout_um = 2;
        QVERIFY2(checkBatch(p).empty(), samples::listed(checkBatch(p)).c_str());
        Project none = ScenarioSource(p).nominal();
        none.machine->geometric_runout_um = 0;
        const double own_mm = simulate(none).sections.front().radialRunout_mm;
        const ScenarioSource source(p);
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            const double factor = source.values(part).front();
            const double runout_mm =
                simulate(source.project(part)).sections.front().radialRunout_mm;
            QVERIFY(within(runout_mm, own_mm + 0.002 * factor, 1e-9));
        }
    }

    void usualBatchHasTheGaugeThatIsKnown() {
        Project p = fixtures::traverse();
        p.machine->geometric_runout_um = 1.5;
        Project usual = withUsualBatch(p);
        QVERIFY(checkBatch(usual).empty());
        QVERIFY(!usual.batch->factors.gauge_error && !usual.batch->factors.gauge_age_h);
        QVERIFY(usual.batch->factors.part_warmer_k.has_value());
        p.machine->gauge_repeatability_um = 1;
        p.machine->gauge_drift_um_h = 1.5;
        p.part->tolerance.radial_runout_um = 6;
        usual = withUsualBatch(p);
        QVERIFY(checkBatch(usual).empty());
        QVERIFY(notCounted(usual).empty());
        const Factor& age = *usual.batch->factors.gauge_age_h;
        const double piece_s = 30 + simulate(p).time_s;
        QCOMPARE(*age.parts_between_dressings, static_cast<int>(std::lround(3600 / piece_s)));
        p.gauge->control = Control::position; // no gauge ends its stages
        usual = withUsualBatch(p);
        QVERIFY(!usual.batch->factors.gauge_error && !usual.batch->factors.part_warmer_k);
        QCOMPARE(notCounted(p).size(), std::size_t{5}); // no batch at all, and nothing is read
        p.gauge->control = Control::gauge;
        QCOMPARE(notCounted(p).size(), std::size_t{8});
    }
};

} // namespace sparkout::test_gauge_factors

SPARKOUT_TEST(test_gauge_factors, TestGaugeFactors)
#include "test_gauge_factors.moc"
