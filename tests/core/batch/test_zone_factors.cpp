// SPDX-License-Identifier: GPL-3.0-or-later
// Stock, runout and compliance that scatter zone by zone: each in its own range, drawn by itself,
// beside the factors of the part, which stay as they were; corners, states, robust search.
#include "core/batch/batch_run.h"
#include "core/batch/batch_state.h"
#include "core/batch/batch_statistics.h"
#include "core/batch/scenario_source.h"
#include "core/batch/sensitivity.h"
#include "core/search/robust.h"
#include "core/study/operation.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_zone_factors {

Project shaft() {
    Project project = samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
    project.batch->zone_stock_mm.reset();
    project.batch->zone_runout_mm.reset();
    project.batch->zone_compliance.reset();
    return project;
}

Project byZones(Project project) {
    project.batch->zone_stock_mm = {{{-0.01, 0.01}, {0, 0}, {-0.005, 0.02}}};
    project.batch->zone_runout_mm = {{{-0.002, 0.002}, {-0.004, 0.001}, {0.001, 0.001}}};
    project.batch->zone_compliance = {{{0.9, 1.1}, {0.8, 1.2}, {1, 1.3}}};
    return project;
}

std::set<std::string> faultsOf(const Project& project) {
    std::set<std::string> paths;
    for (const Issue& issue : checkBatch(project)) {
        paths.insert(issue.path);
    }
    return paths;
}

class TestZoneFactors : public QObject {
    Q_OBJECT

private slots:
    void eachZoneHasItsOwnRange() {
        const Project project = byZones(shaft());
        QVERIFY(faultsOf(project).empty());
        const ScenarioSource source(project);
        const std::size_t ofPart = givenFactors(project).size();
        const std::vector<GivenFactor>& all = source.factors();
        QVERIFY(all.size() == ofPart + 2 + 2 + 3); // a constant is no factor
        std::vector<std::string> keys;
        for (const GivenFactor& factor : all) {
            keys.push_back(factorKey(factor));
        }
        QVERIFY(keys.front() == "stock_mm" && keys[ofPart] == "zone_stock_mm rz1"
                && keys[ofPart + 1] == "zone_stock_mm rz2" && keys.back() == "zone_compliance rz2");
        QVERIFY(std::set<std::string>(keys.begin(), keys.end()).size() == keys.size());
        double least = 1, most = -1;
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            const std::vector<double> values = source.values(part);
            const Project made = source.project(part);
            for (std::size_t f = ofPart; f < all.size(); ++f) {
                const std::vector<double>& ends = *all[f].law.uniform;
                QVERIFY(ends[0] <= values[f] && values[f] <= ends[1]);
                const auto& own = all[f].kind == FactorKind::stock ? made.part->zone_stock_mm
                                  : all[f].kind == FactorKind::runout
                                      ? made.part->zone_runout_mm
                                      : made.machine->zone_compliance;
                QVERIFY(own->at(static_cast<std::size_t>(all[f].place)) == values[f]);
            }
            QVERIFY((*made.part->zone_stock_mm)[1] == 0);
            QVERIFY((*made.part->zone_runout_mm)[2] == 0.001); // the constant
            least = std::min(least, values.back());
            most = std::max(most, values.back());
        }
        QVERIFY(least < 1.01 && most > 1.29); // the strata of a Latin hypercube reach both ends
    }

    void theFactorsOfThePartStayAsTheyWere() {
        for (const Scenarios kind :
             {Scenarios::latin_hypercube, Scenarios::sobol, Scenarios::random}) {
            Project plain = shaft();
            plain.batch->scenarios = kind;
            plain.batch->factors.dullness->parts_between_dressings = 25;
            const ScenarioSource before(plain), after(byZones(plain));
            for (std::int64_t part = 0; part < before.parts(); ++part) {
                const std::vector<double> a = before.values(part), b = after.values(part);
                QVERIFY(std::equal(a.begin(), a.end(), b.begin()));
            }
        }
    }

    void theZonesAreDrawnByThemselves() {
        Project project = byZones(shaft());
        project.batch->parts = 2000;
        const ScenarioSource source(project);
        const std::size_t n = source.factors().size();
        std::vector<std::vector<double>> ranks(n);
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            const std::vector<double> values = source.values(part);
            for (std::size_t f = 0; f < n; ++f) {
                ranks[f].push_back(factorRank(source.factors()[f], values[f]) - 0.5);
            }
        }
        const auto inner = [&](std::size_t a, std::size_t b) {
            double sum = 0;
            for (std::size_t i = 0; i < ranks[a].size(); ++i) {
                sum += ranks[a][i] * ranks[b][i];
            }
            return sum;
        };
        for (std::size_t a = givenFactors(project).size(); a < n; ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                QVERIFY(std::abs(inner(a, b)) < 0.1 * std::sqrt(inner(a, a) * inner(b, b)));
            }
        }
    }

    void cornersTakeBothEndsOfEachZone() {
        Project project = shaft();
        project.batch->factors = {};
        project.batch->scenarios = Scenarios::corners;
        project.batch->zone_compliance = {{{0.9, 1.1}, {1, 1}, {0.8, 1.2}}};
        const ScenarioSource source(project);
        QVERIFY(source.parts() == 4);
        std::set<std::vector<double>> seen;
        for (std::int64_t part = 0; part < 4; ++part) {
            const Project made = source.project(part);
            seen.insert(*made.machine->zone_compliance);
        }
        const std::set<std::vector<double>> corners{
            {0.9, 1, 0.8}, {1.1, 1, 0.8}, {0.9, 1, 1.2}, {1.1, 1, 1.2}};
        QVERIFY(seen == corners);
    }

    void whatCannotBeIsRefused() {
        Project project = shaft();
        project.batch->zone_stock_mm = {{{0, 0.01}, {0, 0.01}}};
        QVERIFY(faultsOf(project) == std::set<std::string>{"/batch/zone_stock_mm"});
        project.batch->zone_stock_mm = {{{0, 0.01}, {0.01, 0}, {0, 0}}};
        QVERIFY(faultsOf(project) == std::set<std::string>{"/batch/zone_stock_mm/1/1"});
        project.batch->zone_stock_mm = {{{-0.2, 0.01}, {0, 0}, {0, 0}}}; // no stock is left
        QVERIFY(faultsOf(project) == std::set<std::string>{"/part/zone_stock_mm/0"});
        Project plunge = fixtures::plunge();
        plunge.sections = 20;
        plunge.machine->compliance_mm_per_n = std::vector<double>(20, 1e-4);
        plunge.batch = Batch{};
        plunge.batch->zone_compliance =
            std::vector<std::vector<double>>(20, std::vector<double>{0.9, 1.1});
        QVERIFY(faultsOf(plunge) == std::set<std::string>{"/batch"}); // more than sixteen
        for (std::size_t i = 16; i < 20; ++i) {
            (*plunge.batch->zone_compliance)[i] = {1, 1};
        }
        QVERIFY(faultsOf(plunge).empty());
    }

    /// Of sixteen sections fed to a position each mean diameter follows from the section's own
    /// factor: its index is 1, those of the others are 0. The points have two coordinates for each
    /// factor.
    void ofAsManyFactorsAsThereMayBeEachHasItsIndex() {
        constexpr std::size_t sections = limits::factors;
        Project plunge = fixtures::plunge();
        plunge.gauge->control = Control::position;
        plunge.sections = static_cast<int>(sections);
        plunge.machine->compliance_mm_per_n = std::vector<double>(sections, 1e-4);
        plunge.batch = Batch{};
        plunge.batch->zone_compliance =
            std::vector<std::vector<double>>(sections, std::vector<double>{0.8, 1.2});
        QVERIFY(faultsOf(plunge).empty());
        const auto indices = sobolIndices(plunge, 512);
        QVERIFY(indices.has_value());
        const std::vector<Characteristic> all = characteristicsOf(plunge);
        std::size_t diameters = 0;
        for (std::size_t c = 0; c < all.size(); ++c) {
            if (std::string(all[c].name) != "diameter") {
                continue;
            }
            ++diameters;
            const std::vector<SobolIndex>& shares = indices->byCharacteristic[c];
            QCOMPARE(shares.size(), sections);
            for (std::size_t f = 0; f < sections; ++f) {
                const double whole = f == static_cast<std::size_t>(all[c].section) ? 1 : 0;
                QVERIFY2(std::abs(shares[f].total - whole) < (whole > 0 ? 0.1 : 1e-9),
                         QByteArray::number(shares[f].total).constData());
            }
        }
        QCOMPARE(diameters, sections);
        plunge.batch->scenarios = Scenarios::sobol;
        plunge.batch->parts = 64;
        const ScenarioSource source(plunge);
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            const std::vector<double> values = source.values(part);
            QVERIFY(std::ranges::all_of(values, [](double v) { return v >= 0.8 && v <= 1.2; }));
            QVERIFY(std::set<double>(values.begin(), values.end()).size() == sections);
        }
    }

    void shardsAddUpToTheWholeBatch() {
        Project project = byZones(shaft());
        project.batch->parts = 40;
        const BatchResult whole = runBatch(project);
        QVERIFY(whole.status == BatchStatus::completed);
        QVERIFY(whole.statistics.values.size() > 0);
        BatchOptions first, second;
        first.range = shardRange(40, 1, 2);
        second.range = shardRange(40, 2, 2);
        BatchJoiner join;
        for (const BatchOptions& options : {first, second}) {
            const std::string state = writeBatchState(runBatch(project, options));
            const ReadBatchState read = readBatchState(state);
            QVERIFY(read.result.has_value());
            join.add(*read.result);
        }
        const JoinedBatch joined = join.join();
        QVERIFY(joined.fault == JoinFault::none);
        QVERIFY(writeBatchState(joined.result) == writeBatchState(whole));
    }

    void aRobustCycleHoldsInAllCorners() {
        Project project = shaft();
        project.batch->factors = {};
        project.batch->zone_compliance = {{{0.8, 1.25}, {0.8, 1.25}, {0.8, 1.25}}};
        project.batch->zone_stock_mm = {{{-0.01, 0.01}, {0, 0}, {-0.01, 0.01}}};
        project.optimisation->scenarios = OptimisationScenarios::corners;
        const RobustSummary robust = optimiseRobustly(project, scenariosAskedFor(project));
        QVERIFY(robust.search.best.has_value());
        project.batch->scenarios = Scenarios::corners;
        const ScenarioSource corners(project);
        QVERIFY(corners.parts() == 32);
        for (std::int64_t part = 0; part < corners.parts(); ++part) {
            Project made = corners.project(part);
            *made.cycle = robust.search.cycle;
            const SimulationResult result = simulateUnchecked(made);
            QVERIFY(result.status == RunStatus::completed);
            QVERIFY(std::ranges::all_of(evaluateConstraints(result), &ConstraintResult::holds));
        }
    }

    void otherZonesHaveNoneOfThem() {
        Project project = byZones(shaft());
        project.part->zone_stock_mm = {{0.001, 0, 0}};
        project.machine->zone_compliance = {{1, 1, 1.1}};
        const Project plunge = withOperation(project, Operation::plunge);
        QVERIFY(!plunge.part->zone_stock_mm && !plunge.machine->zone_compliance);
        QVERIFY(!plunge.batch->zone_stock_mm && !plunge.batch->zone_compliance);
    }
};

} // namespace sparkout::test_zone_factors

SPARKOUT_TEST(test_zone_factors, TestZoneFactors)
#include "test_zone_factors.moc"
