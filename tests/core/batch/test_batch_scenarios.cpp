// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/project/validate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"

#include "core/cholesky.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <boost/random/sobol.hpp>

#include <set>

namespace sparkout::test_batch_scenarios {

using fixtures::normal;
using fixtures::uniform;

Project batchOf(Scenarios scenarios, int parts) {
    Project project = fixtures::plunge();
    project.batch = Batch{};
    project.batch->parts = parts;
    project.batch->scenarios = scenarios;
    project.batch->factors.stock_mm = uniform(0.15, 0.25);
    project.batch->factors.dullness = uniform(0.01, 0.03);
    project.batch->factors.flow_stress_mpa = uniform(1900, 2100);
    return project;
}

/// Correlation of the values of two factors over the batch.
double correlationOf(const ScenarioSource& source, std::size_t a, std::size_t b) {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    const auto n = static_cast<double>(source.parts());
    for (std::int64_t part = 0; part < source.parts(); ++part) {
        const std::vector<double> values = source.values(part);
        x += values[a];
        y += values[b];
        xx += values[a] * values[a];
        yy += values[b] * values[b];
        xy += values[a] * values[b];
    }
    return (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
}

class TestBatchScenarios : public QObject {
    Q_OBJECT

private slots:
    // SALMON2011, known answers of the authors' Random123 (kat_vectors).
    void philoxGivesTheKnownAnswers() {
        QVERIFY((philox({0, 0, 0, 0}, {0, 0})
                 == PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
        constexpr std::uint32_t f = 0xffffffff;
        QVERIFY((philox({f, f, f, f}, {f, f})
                 == PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
        QVERIFY((philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0})
                 == PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
    }

    void aPermutationReachesEveryValueOnce() {
        for (const std::uint64_t count : {1U, 2U, 3U, 50U, 64U, 1000U}) {
            std::set<std::uint64_t> reached;
            for (std::uint64_t i = 0; i < count; ++i) {
                reached.insert(permuted(i, count, 7, 2));
            }
            QCOMPARE(reached.size(), static_cast<std::size_t>(count));
            QVERIFY(*reached.rbegin() == count - 1);
        }
    }

    // Boost has the table of Joe and Kuo too; its points come in Gray-code order, without
    // the first, which is 0.
    void sobolPointsAreThoseOfAnotherImplementation() {
        boost::random::sobol_engine<std::uint32_t, 32> other(sobolDimensions);
        for (std::uint32_t i = 1; i < 200; ++i) {
            const std::uint32_t gray = i ^ (i >> 1);
            for (int d = 0; d < sobolDimensions; ++d) {
                QCOMPARE(sobolCoordinate(gray, d), other());
            }
        }
    }

    void everyStratumOfALatinHypercubeHoldsOnePart() {
        const ScenarioSource source(batchOf(Scenarios::latin_hypercube, 50));
        for (std::size_t f = 0; f < source.factors().size(); ++f) {
            const auto& ends = *source.factors()[f].law.uniform;
            std::set<int> strata;
            for (std::int64_t part = 0; part < 50; ++part) {
                const double u = (source.values(part)[f] - ends[0]) / (ends[1] - ends[0]);
                strata.insert(static_cast<int>(u * 50));
            }
            QCOMPARE(strata.size(), std::size_t{50});
            QCOMPARE(*strata.begin(), 0);
            QCOMPARE(*strata.rbegin(), 49);
        }
    }

    void anotherSeedIsAnotherBatch_data() {
        QTest::addColumn<int>("scenarios");
        addRow("latin hypercube", static_cast<int>(Scenarios::latin_hypercube));
        addRow("sobol", static_cast<int>(Scenarios::sobol));
        addRow("random", static_cast<int>(Scenarios::random));
    }
    void anotherSeedIsAnotherBatch() {
        QFETCH(int, scenarios);
        Project project = batchOf(static_cast<Scenarios>(scenarios), 50);
        const ScenarioSource one(project), same(project);
        project.batch->seed = 2;
        const ScenarioSource two(project);
        for (std::int64_t part = 0; part < 50; ++part) {
            QCOMPARE(one.values(part), same.values(part));
            QVERIFY(one.values(part) != two.values(part));
        }
    }

    void cornersAreAllCombinationsOfTheEnds() {
        const ScenarioSource source(batchOf(Scenarios::corners, 50));
        QCOMPARE(source.parts(), std::int64_t{8});
        QVERIFY(!source.isSample());
        std::set<std::vector<double>> corners;
        for (std::int64_t part = 0; part < 8; ++part) {
            const std::vector<double> values = source.values(part);
            corners.insert(values);
            for (std::size_t f = 0; f < values.size(); ++f) {
                const auto& ends = *source.factors()[f].law.uniform;
                QVERIFY(values[f] == ends[0] || values[f] == ends[1]);
            }
        }
        QCOMPARE(corners.size(), std::size_t{8});
    }

    void dullnessGrowsFromDressingToDressing() {
        Project project = batchOf(Scenarios::latin_hypercube, 50);
        project.batch->factors.dullness = Factor{};
        project.batch->factors.dullness->grows = {0.01, 0.03};
        project.batch->factors.dullness->parts_between_dressings = 5;
        const ScenarioSource source(project);
        for (std::int64_t part = 0; part < 50; ++part) {
            QVERIFY(
                fixtures::close(source.values(part)[1], 0.01 + 0.005 * double(part % 5), 1e-14));
        }
    }

    void theWheelGetsSmallerWithDressingsAndItsSpeedAsTheDriveHasIt() {
        Project project = fixtures::plunge();
        project.batch = Batch{};
        project.batch->parts = 20;
        Factor wheel;
        wheel.grows = {500, 450};
        wheel.parts_between_dressings = 10;
        project.batch->factors.wheel_diameter_mm = wheel;
        const double rate = project.machine->wheel_speed_m_s / project.wheel->diameter_mm;
        for (const auto control :
             {WheelSpeedControl::constant_speed, WheelSpeedControl::constant_revolutions}) {
            const bool falls = control == WheelSpeedControl::constant_revolutions;
            project.machine->wheel_speed_control = control;
            const ScenarioSource source(project);
            const Project last = source.project(9), dressed = source.project(10);
            QCOMPARE(last.wheel->diameter_mm, 500.0);
            QCOMPARE(dressed.wheel->diameter_mm, 450.0);
            QVERIFY(fixtures::close(dressed.machine->wheel_speed_m_s,
                                    falls ? 450 * rate : project.machine->wheel_speed_m_s, 1e-14));
        }
    }

    // Quantiles of the truncated law by its own distribution function.
    void aTruncatedNormalFactorHasItsShares() {
        Factor law = normal(0.2, 0.1);
        law.within = {0.1, 0.25};
        const GivenFactor factor{FactorKind::stock, law, {0, 10}};
        const auto phi = [](double x) { return std::erfc(-(x - 0.2) / 0.1 / std::sqrt(2.0)) / 2; };
        for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999}) {
            const double x = factorQuantile(factor, share);
            QVERIFY(fixtures::within((phi(x) - phi(0.1)) / (phi(0.25) - phi(0.1)), share, 1e-12));
        }
    }

    void theTriangleOfAMatrixGivesItBack() {
        const std::vector<std::vector<double>> matrix{
            {1, 0.5, 0.3, -0.2}, {0.5, 1, -0.4, 0.1}, {0.3, -0.4, 1, 0.25}, {-0.2, 0.1, 0.25, 1}};
        const auto lower = choleskyFactor(matrix);
        QVERIFY(lower);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                double product = 0;
                for (std::size_t k = 0; k <= j; ++k) {
                    product += (*lower)[i][k] * (*lower)[j][k];
                }
                QVERIFY(fixtures::within(product, matrix[i][j], 1e-15));
            }
        }
    }

    /// A drift from part to part does not go in step with the bits of a Sobol sequence: the
    /// first coordinate of every other point lies in the upper half.
    void aDriftIsNotConfoundedWithASobolSequence() {
        for (const int between : {2, 4, 64}) {
            Project project = batchOf(Scenarios::sobol, 1024);
            project.batch->factors.dullness = Factor{};
            project.batch->factors.dullness->grows = {0.01, 0.03};
            project.batch->factors.dullness->parts_between_dressings = between;
            const ScenarioSource source(project);
            for (const std::size_t other : {0U, 2U}) {
                const double r = correlationOf(source, 1, other);
                QVERIFY2(std::abs(r) < 0.12, qPrintable(QString::number(r))); // 4/√1024
            }
            QVERIFY(fixtures::within(correlationOf(source, 0, 2), 0, 0.01)); // still a sequence
        }
    }

    /// The rank of a value is the share that was asked of its law; equal values share
    /// theirs.
    void theRankOfAQuantileIsItsShare() {
        Factor truncated = normal(0.2, 0.1);
        truncated.within = {0.1, 0.25};
        for (const Factor& law :
             {uniform(0.1, 0.3), normal(0.2, 0.1), truncated, fixtures::triangular(0.1, 0.15, 0.3),
              fixtures::triangular(0.1, 0.1, 0.3), fixtures::triangular(0.1, 0.3, 0.3)}) {
            const GivenFactor factor{FactorKind::stock, law, {-10, 10}};
            for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999}) {
                QVERIFY(fixtures::within(factorRank(factor, factorQuantile(factor, share)), share,
                                         1e-9));
            }
        }
        const GivenFactor few{FactorKind::stock, fixtures::measured({0.1, 0.2, 0.2, 0.4}), {0, 1}};
        QCOMPARE(factorRank(few, 0.1), 0.125);
        QCOMPARE(factorRank(few, 0.2), 0.5);
        QCOMPARE(factorRank(few, 0.4), 0.875);
        Factor falling;
        falling.grows = {500, 450};
        const GivenFactor wheel{FactorKind::wheelDiameter, falling, {0, 1000}};
        QCOMPARE(factorRank(wheel, 500), 1.0);
        QCOMPARE(factorRank(wheel, 460), 0.2);
        for (const Factor& constant :
             {uniform(0.2, 0.2), normal(0.2, 0), fixtures::triangular(0.2, 0.2, 0.2),
              fixtures::measured({0.2, 0.2})}) {
            QCOMPARE(factorRank({FactorKind::stock, constant, {0, 1}}, 0.2), 0.5);
        }
    }

    // Of normal factors R is Pearson's correlation, of uniform ones (6/π)·asin(R/2).
    void factorsAreCorrelatedAsTheMatrixSays() {
        Project project = batchOf(Scenarios::sobol, 4096);
        project.batch->factors.flow_stress_mpa = normal(2000, 50);
        project.batch->factors.compliance = normal(1, 0.05);
        project.batch->correlation = {
            {1, 0.6, 0, 0}, {0.6, 1, 0, 0}, {0, 0, 1, -0.7}, {0, 0, -0.7, 1}};
        QVERIFY(checkBatch(project).empty());
        const ScenarioSource source(project);
        const double rank = 6 / std::numbers::pi * std::asin(0.3);
        QVERIFY(fixtures::within(correlationOf(source, 0, 1), rank, 0.005));
        QVERIFY(fixtures::within(correlationOf(source, 2, 3), -0.7, 0.005));
        QVERIFY(fixtures::within(correlationOf(source, 0, 2), 0, 0.01));
    }

    void aBatchThatCannotBeIsRefused_data() {
        addColumns<QString, QString>("fault", "path");
        addRow("two forms", "forms", "/batch/factors/stock_mm");
        addRow("reversed", "reversed", "/batch/factors/stock_mm/uniform/1");
        addRow("outside", "outside", "/batch/factors/dullness/uniform/1");
        addRow("no form", "none", "/batch/factors/stock_mm");
        addRow("nothing measured", "unmeasured", "/batch/factors/stock_mm/measured");
        addRow("measured outside", "mismeasured", "/batch/factors/dullness/measured/1");
        addRow("mode beyond the ends", "mode", "/batch/factors/stock_mm/triangular/2");
        addRow("negative scatter", "scatter", "/batch/factors/stock_mm/normal/1");
        addRow("mean outside", "mean", "/batch/factors/dullness/normal/0");
        addRow("within without normal", "within", "/batch/factors/stock_mm/within");
        addRow("dressings without growth", "dressings",
               "/batch/factors/stock_mm/parts_between_dressings");
        addRow("part beyond the wheel", "width", "/wheel/width_mm");
        addRow("small matrix", "small", "/batch/correlation");
        addRow("not symmetric", "skew", "/batch/correlation/1/0");
        addRow("not definite", "indefinite", "/batch/correlation");
        addRow("correlated law", "law", "/batch/correlation/1/0");
    }
    void aBatchThatCannotBeIsRefused() {
        QFETCH(QString, fault);
        QFETCH(QString, path);
        Project project = batchOf(Scenarios::latin_hypercube, 50);
        Batch& batch = *project.batch;
        QVERIFY(checkBatch(project).empty());
        if (fault == "forms") {
            batch.factors.stock_mm->normal = {0.2, 0.01};
        } else if (fault == "reversed") {
            batch.factors.stock_mm = uniform(0.25, 0.15);
        } else if (fault == "outside") {
            batch.factors.dullness = uniform(0.01, 1.5);
        } else if (fault == "none") {
            batch.factors.stock_mm = Factor{};
        } else if (fault == "unmeasured") {
            batch.factors.stock_mm = fixtures::measured({});
        } else if (fault == "mismeasured") {
            batch.factors.dullness = fixtures::measured({0.9, 1.5});
        } else if (fault == "mode") {
            batch.factors.stock_mm = fixtures::triangular(0.1, 0.3, 0.2);
        } else if (fault == "scatter") {
            batch.factors.stock_mm = normal(0.2, -0.01);
        } else if (fault == "mean") {
            batch.factors.dullness = normal(-0.01, 0.01);
        } else if (fault == "within") {
            batch.factors.stock_mm->within = {0.1, 0.2};
        } else if (fault == "dressings") {
            batch.factors.stock_mm->parts_between_dressings = 5;
        } else if (fault == "width") {
            batch.factors.contact_width_mm = uniform(30, 41); // the wheel is 40 mm wide
        } else if (fault == "small") {
            batch.correlation = std::vector(1, std::vector<double>{1});
        } else if (fault == "skew") {
            batch.correlation = {{1, 0.5, 0}, {0.4, 1, 0}, {0, 0, 1}};
        } else if (fault == "indefinite") {
            batch.correlation = {{1, 0.9, 0.9}, {0.9, 1, -0.9}, {0.9, -0.9, 1}};
        } else {
            batch.factors.dullness = Factor{};
            batch.factors.dullness->grows = {0.01, 0.03};
            batch.correlation = {{1, 0.5, 0}, {0.5, 1, 0}, {0, 0, 1}};
        }
        const Issues issues = checkBatch(project);
        QVERIFY(!issues.empty());
        QCOMPARE(QString::fromStdString(issues.front().path), path);
    }

    /// A cycle does not read the batch: its faults are warnings there.
    void aBatchThatCannotBeDoesNotRefuseTheCycle() {
        Project project = batchOf(Scenarios::latin_hypercube, 50);
        project.batch->factors.dullness = uniform(0.03, 0.01);
        const Issues issues = validate(project);
        QVERIFY(!hasErrors(issues));
        QVERIFY(std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
            return issue.path == "/batch/factors/dullness/uniform/1";
        }));
        QVERIFY(hasErrors(checkBatch(project)));
    }
};

} // namespace sparkout::test_batch_scenarios

SPARKOUT_TEST(test_batch_scenarios, TestBatchScenarios)
#include "test_batch_scenarios.moc"
