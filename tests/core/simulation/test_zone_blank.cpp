// SPDX-License-Identifier: GPL-3.0-or-later
// A blank whose zones or sections have a stock and runout of their own, and a compliance factor:
// the balance of every pass, the first touch, limits in which it is the plain blank; searches and
// phases of the stock of such parts against running every cycle.
#include "core/phases/phase_decision.h"
#include "core/process/system_compliance.h"
#include "core/project/validate.h"
#include "tests/core/search/search_checks.h"
#include "tests/core/support/random_project.h"
#include "tests/registry.h"

#include <cstdio>
#include <numeric>
#include <set>

namespace sparkout::test_zone_blank {

using namespace search_checks;
using fixtures::within;

Project shaft() {
    return samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
}

bool sameRadii(const SimulationResult& a, const SimulationResult& b) {
    return std::ranges::equal(a.sections, b.sections, [](const auto& x, const auto& y) {
        return x.radii_mm == y.radii_mm;
    });
}

/// Own stocks, runouts and compliances of all places, at random within a share of the part's.
Project scattered(Project p, std::mt19937_64& random) {
    std::uniform_real_distribution<double> share(-0.4, 0.4);
    const auto places = static_cast<std::size_t>(placeCount(p));
    std::vector<double> stock(places), runout(places), factor(places);
    for (std::size_t i = 0; i < places; ++i) {
        stock[i] = share(random) * p.part->stock_mm;
        runout[i] = share(random) * initialRunout(*p.part);
        factor[i] = 1 + share(random);
    }
    p.part->zone_stock_mm = stock;
    p.part->zone_runout_mm = runout;
    if (!p.sections_coupled) {
        p.machine->zone_compliance = factor;
    }
    return p;
}

class TestZoneBlank : public QObject {
    Q_OBJECT

private slots:
    void nothingOfItsOwnIsThePlainBlankBitByBit() {
        for (const char* name : {"resources/examples/shaft-30h6-factory.sparkout",
                                 "resources/examples/plunge-shaft-two-stage.sparkout",
                                 "resources/examples/internal-plunge.sparkout"}) {
            const Project plain = samples::projectIn(name);
            Project same = plain;
            const auto places = static_cast<std::size_t>(placeCount(plain));
            same.part->zone_stock_mm = std::vector<double>(places, 0.0);
            same.part->zone_runout_mm = std::vector<double>(places, 0.0);
            same.machine->zone_compliance = std::vector<double>(places, 1.0);
            const SimulationResult a = simulate(plain), b = simulate(same);
            QVERIFY(a.status == RunStatus::completed && a.time_s == b.time_s);
            QVERIFY(sameRadii(a, b));
        }
    }

    void theSameEverywhereIsThePartsOwn() {
        const Project plain = shaft();
        Project moved = plain, stated = plain;
        moved.part->zone_stock_mm = {{0.01, 0.01, 0.01}};
        moved.part->zone_runout_mm = {{0.004, 0.004, 0.004}};
        stated.part->stock_mm += 0.01;
        stated.part->initial_runout_mm += 0.004;
        const SimulationResult a = simulate(moved), b = simulate(stated);
        QVERIFY(a.countsByStage == b.countsByStage);
        for (std::size_t i = 0; i < a.sections.size(); ++i) {
            for (std::size_t k = 0; k < a.sections[i].radii_mm.size(); ++k) {
                QVERIFY(within(a.sections[i].radii_mm[k], b.sections[i].radii_mm[k], 1e-11));
            }
        }
    }

    // R_max of a zone is R_t + Π + δΠ + ΔR + δ(ΔR); depths count from the largest of all zones.
    void theZonesStandWhereTheyAreStated() {
        for (const bool bore : {false, true}) {
            Project p = shaft();
            p.part->surface = bore ? Surface::internal : Surface::external;
            p.part->zone_stock_mm = {{0.02, -0.01, 0}};
            p.part->zone_runout_mm = {{-0.005, 0.01, 0}};
            const Blank blank = makeBlank(*p.part);
            QVERIFY(blank.placeDepth_mm.size() == 3);
            const double whole = p.part->stock_mm + p.part->initial_runout_mm;
            QVERIFY(within(blank.totalInfeed_mm, whole + 0.015, 1e-12));
            for (std::size_t zone = 0; zone < 3; ++zone) {
                const double stock = p.part->stock_mm + (*p.part->zone_stock_mm)[zone];
                const double runout = p.part->initial_runout_mm + (*p.part->zone_runout_mm)[zone];
                const auto [least, most] = std::ranges::minmax(blank.depthAt(zone));
                QVERIFY(within(least, blank.totalInfeed_mm - stock - runout, 1e-12));
                QVERIFY(within(most, blank.totalInfeed_mm - stock, 1e-12));
            }
        }
    }

    // a + γ·P_y(a) = t_П − (R_first − R_k) before the pass, with the zone's own γ.
    void everyPassBalances() {
        std::mt19937_64 random(8);
        for (const char* name : {"resources/examples/shaft-30h6-factory.sparkout",
                                 "resources/examples/plunge-shaft-two-stage.sparkout"}) {
            const Project p = scattered(samples::projectIn(name), random);
            const Blank blank = makeBlank(*p.part);
            Trajectory trajectory;
            const SimulationResult result = simulate(p, &trajectory);
            QVERIFY(!trajectory.passes.empty());
            const Project plain = samples::projectIn(name);
            const std::vector<CompliantPoint> gammas = compliantPoints(plain);
            std::set<std::size_t> seen;
            for (const Pass& pass : trajectory.passes) {
                const std::size_t place = p.operation->travels
                                              ? static_cast<std::size_t>(pass.place.zone)
                                              : static_cast<std::size_t>(pass.place.section);
                const bool first = seen.insert(place).second;
                const double gamma =
                    gammas[place].gamma_mm_n * (*p.machine->zone_compliance)[place];
                for (int k = 0; k < trajectory.radii; ++k) {
                    const Visit& visit =
                        trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
                    const double before = visit.radius_mm + visit.actual_mm;
                    const double lag = visit.programmed_mm - (blank.firstTouchRadius_mm - before);
                    if (visit.actual_mm > 0) {
                        QVERIFY(within(visit.actual_mm + gamma * visit.normalForce_n, lag, 1e-10));
                    } else {
                        QVERIFY(lag < 1e-10);
                    }
                    if (first) {
                        QVERIFY(within(blank.firstTouchRadius_mm - before,
                                       blank.depthAt(place)[static_cast<std::size_t>(k)], 1e-12));
                    }
                    QVERIFY(within(visit.accumulated_mm,
                                   blank.firstTouchRadius_mm
                                       - blank.depthAt(place)[static_cast<std::size_t>(k)]
                                       - visit.radius_mm,
                                   1e-11));
                }
            }
            QVERIFY(seen.size() == static_cast<std::size_t>(placeCount(p)));
            QVERIFY(result.visits > 0);
        }
    }

    void aFactorMultipliesComplianceGivenAndComputed() {
        Project given = shaft();
        given.machine->zone_compliance = {{2.0, 1.0, 0.5}};
        const auto plain = compliantPoints(shaft()), scaled = compliantPoints(given);
        QVERIFY(within(scaled[0].gamma_mm_n, 2 * plain[0].gamma_mm_n, 1e-18));
        QVERIFY(scaled[1].gamma_mm_n == plain[1].gamma_mm_n);
        QVERIFY(within(scaled[2].gamma_mm_n, plain[2].gamma_mm_n / 2, 1e-18));
        Project computed = samples::projectIn("resources/examples/slender-shaft.sparkout");
        const auto before = compliantPoints(computed);
        computed.machine->zone_compliance = std::vector<double>(before.size(), 3.0);
        const auto after = compliantPoints(computed);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QVERIFY(fixtures::close(after[i].gamma_mm_n, 3 * before[i].gamma_mm_n, 1e-14));
        }
        Project several = shaft();
        several.zone_sections = 3;
        const auto sections = zoneSectionPoints(several);
        several.machine->zone_compliance = {{2.0, 1.0, 1.0}};
        const auto doubled = zoneSectionPoints(several);
        for (std::size_t i = 0; i < sections.size(); ++i) {
            QVERIFY(fixtures::close(doubled[i].gamma_mm_n, (i < 3 ? 2 : 1) * sections[i].gamma_mm_n,
                                    1e-14));
        }
    }

    void sectionsOfAZoneHaveItsBlank() {
        Project p = shaft();
        p.zone_sections = 2;
        p.part->zone_stock_mm = {{-0.05, 0, 0}};
        Project plain = p;
        plain.part->zone_stock_mm.reset();
        p.cycle->stages.resize(1);
        p.cycle->stages.front().stock_mm = p.part->stock_mm;
        plain.cycle->stages = p.cycle->stages;
        const SimulationResult own = simulate(p), same = simulate(plain);
        QVERIFY(own.zoneSections.size() == 6 && own.status == RunStatus::completed);
        QVERIFY(placeOfPoint(p, 3) == 0 && placeOfPoint(p, 4) == 0 && placeOfPoint(p, 8) == 2);
        QVERIFY(own.countsByStage == same.countsByStage);
    }

    void whatIsNoBlankIsRefused() {
        const auto paths = [](const Project& p) {
            std::set<std::string> found;
            for (const Issue& issue : validate(p)) {
                if (issue.severity == Severity::error) {
                    found.insert(issue.path);
                }
            }
            return found;
        };
        Project p = shaft();
        p.part->zone_stock_mm = {{0, 0}};
        QVERIFY(paths(p) == std::set<std::string>{"/part/zone_stock_mm"});
        p.part->zone_stock_mm = {{0, -p.part->stock_mm, 0}};
        QVERIFY(paths(p) == std::set<std::string>{"/part/zone_stock_mm/1"});
        p = shaft();
        p.part->zone_runout_mm = {{0, 0, -0.03}};
        QVERIFY(paths(p) == std::set<std::string>{"/part/zone_runout_mm/2"});
        p.part->zone_runout_mm = {{0, 0, -0.02}};
        QVERIFY(paths(p).empty());
        p.machine->zone_compliance = {{1, 1, 0}};
        QVERIFY(paths(p) == std::set<std::string>{"/machine/zone_compliance/2"});
        Project coupled = samples::projectIn("resources/examples/slender-shaft.sparkout");
        if (!coupled.operation->travels) {
            coupled.sections_coupled = true;
            coupled.machine->zone_compliance =
                std::vector<double>(static_cast<std::size_t>(coupled.sections), 1.0);
            QVERIFY(paths(coupled).contains("/machine/zone_compliance"));
        }
    }

    // The bounds of the search hold for blanks of any zones: the answer is that of running all.
    void thePrunedSearchFindsTheFullSearchsCycle() {
        std::mt19937_64 random(25);
        int found = 0;
        for (unsigned seed = 0; seed < searches(120); ++seed) {
            const Project p = scattered(smallCase(seed), random);
            const SearchSummary full = search(p, SearchMethod::full);
            const SearchSummary pruned = search(p);
            QVERIFY2(same(pruned, full), qPrintable(QString::number(seed)));
            found += full.best ? 1 : 0;
        }
        std::printf("searches of scattered zones with a cycle: %d\n", found);
        QVERIFY(found > 10);
    }

    void thePhasesAreThoseOfSingleStocks() {
        std::mt19937_64 random(12);
        int decided = 0;
        for (std::uint64_t seed = 1;
             seed <= static_cast<std::uint64_t>(samples::sized(60, 12, 600)); ++seed) {
            ReadResult read = readProject(randomProject(seed).dump());
            if (!read.project) {
                continue;
            }
            Project p = scattered(*read.project, random);
            p.gauge->control = Control::gauge;
            p.gauge->datum_mm.reset();
            const bool valid = std::ranges::none_of(
                validate(p), [](const Issue& issue) { return issue.severity == Severity::error; });
            const StockRange range = valid ? usualPhases(p) : StockRange{};
            const PhaseDecision decision = valid ? decidePhases(p, range) : PhaseDecision{};
            if (!decision.isDecided) {
                continue;
            }
            ++decided;
            std::uniform_real_distribution<double> stock(range.from_mm, range.to_mm);
            for (int i = 0; i < 20; ++i) {
                p.part->stock_mm = stock(random);
                const SimulationResult run = simulateUnchecked(p);
                const bool any = std::ranges::any_of(decision.pieces, [&](const auto& each) {
                    const PhasePiece& piece = each.piece;
                    return piece.from_mm - 1e-9 <= p.part->stock_mm
                           && p.part->stock_mm <= piece.to_mm + 1e-9 && piece.status == run.status
                           && (run.status != RunStatus::completed
                               || piece.counts == run.countsByStage);
                });
                QVERIFY2(any, qPrintable(QString::number(seed)));
            }
        }
        QVERIFY(decided > 5);
    }
};

} // namespace sparkout::test_zone_blank

SPARKOUT_TEST(test_zone_blank, TestZoneBlank)
#include "test_zone_blank.moc"
