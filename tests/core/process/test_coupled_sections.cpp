// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/coupled_sections.h"
#include "core/process/pass_kernel.h"

#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/dense.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <rapidcheck.h>

#include <utility>

namespace sparkout::test_coupled_sections {

using fixtures::within;

/// A system of sections; the conditions are written out here a second time.
struct System {
    std::vector<double> G, width;
    ForceLaw law;

    [[nodiscard]] std::size_t size() const { return width.size(); }
    [[nodiscard]] double sliceForce(double u, std::size_t j) const {
        return width[j] * (law.ks * u * u + law.kr * u);
    }
    /// r_j = a_j + Σ_l G_jl·p(a_l)·Δx_l − h_j
    [[nodiscard]] std::vector<double> rest(const std::vector<double>& u,
                                           const std::vector<double>& h) const {
        std::vector<double> r;
        for (std::size_t j = 0; j < size(); ++j) {
            long double sum = static_cast<long double>(u[j]) * u[j] - h[j];
            for (std::size_t l = 0; l < size(); ++l) {
                sum += static_cast<long double>(G[j * size() + l]) * sliceForce(u[l], l);
            }
            r.push_back(static_cast<double>(sum));
        }
        return r;
    }
    /// How far u is from a ≥ 0, r ≥ 0, a·r = 0 [mm].
    [[nodiscard]] double fault(const std::vector<double>& u, const std::vector<double>& h) const {
        const std::vector<double> r = rest(u, h);
        double worst = 0;
        for (std::size_t j = 0; j < size(); ++j) {
            if (!(u[j] >= 0)) {
                return std::numeric_limits<double>::infinity();
            }
            worst = std::max(worst, std::abs(std::min(u[j] * u[j], r[j])));
        }
        return worst;
    }
};

struct Solution {
    CoupledSections::Outcome outcome;
    std::vector<double> u, force;
};

Solution solve(const System& system, const std::vector<double>& h, std::vector<double> from = {}) {
    CoupledSections sections(system.G, system.width, system.law);
    Solution solution;
    solution.u = from.empty() ? std::vector<double>(h.size()) : std::move(from);
    solution.outcome = sections.solve(h.data(), solution.u.data());
    for (std::size_t j = 0; j < h.size(); ++j) {
        solution.force.push_back(system.sliceForce(solution.u[j], j));
    }
    return solution;
}

constexpr ForceLaw usual{.ks = 30.7, .kr = 71.3, .kt = 45, .mu = 0.3}; // the vectors' page
constexpr ForceLaw sharp{.ks = 30.7, .kr = 0, .kt = 45, .mu = 0.3};
constexpr ForceLaw dull{.ks = 30.7, .kr = 700, .kt = 45, .mu = 0.3};

double uniform(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}
double logUniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
}

/// A random elastic system: a sum of `rank` products v·vᵀ, singular when there are few.
System randomSystem(std::size_t J, std::size_t rank) {
    System system;
    system.law = {.ks = logUniform(1, 300), .kr = *rc::gen::element(0.0, 1.0) * logUniform(1, 1e3)};
    system.G.assign(J * J, 0);
    const double scale = logUniform(1e-7, 1e-3);
    for (std::size_t i = 0; i < rank; ++i) {
        std::vector<double> v;
        for (std::size_t j = 0; j < J; ++j) {
            v.push_back(uniform(-1, 1));
        }
        for (std::size_t j = 0; j < J * J; ++j) {
            system.G[j] += scale * v[j / J] * v[j % J];
        }
    }
    for (std::size_t j = 0; j < J; ++j) {
        system.width.push_back(logUniform(0.2, 20));
    }
    return system;
}

std::vector<double> randomLags(std::size_t J) {
    std::vector<double> h;
    const double scale = logUniform(1e-6, 1);
    for (std::size_t j = 0; j < J; ++j) {
        h.push_back(scale * uniform(-0.4, 1));
    }
    return h;
}

/// The bending of a long beam between its supports: smooth, so nearly singular for many sections.
System beam(std::size_t J, const ForceLaw& law) {
    System system{.G = {}, .width = std::vector<double>(J, 40.0 / double(J)), .law = law};
    for (std::size_t j = 0; j < J; ++j) {
        for (std::size_t l = 0; l < J; ++l) {
            const double x = (double(std::min(j, l)) + 0.5) / double(J);
            const double s = (double(std::max(j, l)) + 0.5) / double(J);
            const double bent = x * (1 - s) * (1 - x * x - (1 - s) * (1 - s)) / 6;
            system.G.push_back(2e-5 + (1 - x) * (1 - s) * 1.6e-5 + x * s * 2.5e-5 + 1e-3 * bent);
        }
    }
    return system;
}

/// The root of A·a + C·√a = h, solved in long double.
double closedForm(double gamma, double width, const ForceLaw& law, double h) {
    const long double g = gamma;
    const long double A = 1 + g * width * law.ks;
    const long double C = g * width * law.kr;
    return h > 0 ? static_cast<double>(2 * h / (C + std::sqrt(C * C + 4 * A * h))) : 0;
}

/// The linear case (no dullness) by trying every set of sections in contact.
std::optional<std::vector<double>> bruteForce(const System& s, const std::vector<double>& h) {
    const std::size_t J = h.size();
    for (unsigned set = 0; set < (1u << J); ++set) {
        dense::Matrix M(J, std::vector<double>(J));
        std::vector<double> right(J);
        for (std::size_t j = 0; j < J; ++j) {
            M[j][j] = 1;
            if (set >> j & 1u) {
                right[j] = h[j];
                for (std::size_t l = 0; l < J; ++l) {
                    M[j][l] += s.G[j * J + l] * s.width[l] * s.law.ks;
                }
            }
        }
        const std::vector<double> a = dense::solved(M, right);
        std::vector<double> u;
        for (const double depth : a) {
            u.push_back(std::sqrt(std::max(0.0, depth)));
        }
        if (*std::min_element(a.begin(), a.end()) >= -1e-13 && s.fault(u, h) < 1e-12) {
            return a;
        }
    }
    return std::nullopt;
}

/// Whether random systems of so many sections, of `mostProducts(sections)` products or fewer, are
/// solved to their conditions.
bool areSolved(const std::string& name, std::pair<int, int> sections,
               int (*mostProducts)(int sections)) {
    return rc::check(name, [=] {
        const int count = *rc::gen::inRange(sections.first, sections.second + 1);
        const int most = mostProducts(count);
        const System system =
            randomSystem(static_cast<std::size_t>(count),
                         static_cast<std::size_t>(*rc::gen::inRange(1, most + 1)));
        const std::vector<double> h = randomLags(static_cast<std::size_t>(count));
        const Solution solution = solve(system, h);
        RC_ASSERT(solution.outcome.converged);
        RC_ASSERT(system.fault(solution.u, h) < 1e-12);
    });
}

class TestCoupledSections : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(1000); }

    void oneSectionIsTheClosedForm_data() {
        addColumns<double, double, double>("gamma", "kr", "lag");
        for (const double gamma : {1e-9, 2e-5, 1e-2}) {
            for (const double kr : {0.0, 71.3, 700.0}) {
                for (const double lag : {-1e-3, 0.0, 1e-7, 5e-3, 0.3}) {
                    QTest::addRow("%g %g %g", gamma, kr, lag) << gamma << kr << lag;
                }
            }
        }
    }
    void oneSectionIsTheClosedForm() {
        QFETCH(double, gamma);
        QFETCH(double, kr);
        QFETCH(double, lag);
        ForceLaw law = usual;
        law.kr = kr;
        const Solution solution = solve({{gamma}, {40}, law}, {lag});
        QVERIFY(solution.outcome.converged);
        const double u = closedForm(gamma, 40, law, lag);
        QVERIFY(within(solution.u[0] * solution.u[0], u * u, 1e-13));
        QVERIFY(within(solution.force[0], 40 * law.normal(1, solution.u[0]), 1e-9));
    }

    // The same over a whole cycle, warm-started, against the pass of the independent model.
    void diagonalCycleIsThePassKernels() {
        constexpr std::size_t J = 5;
        constexpr double length = 40;
        const double gammas[J] = {1e-5, 4e-5, 9e-5, 2e-5, 3e-5};
        System system{.G = std::vector<double>(J * J), .width = {}, .law = usual};
        Lanes lanes(J);
        LaneCoefficients coefficients(J);
        for (std::size_t j = 0; j < J; ++j) {
            system.width.push_back(length / J);
            system.G[j * (J + 1)] = gammas[j] * J; // G_jj·Δx = γ_j·L_p
            lanes.share[j] = 1;
            lanes.depth_mm[j] = 0.003 * double(j);
            coefficients.set(j, gammas[j], length * usual.ks, length * usual.kr);
        }
        std::vector<double> depth = lanes.depth_mm, u(J), h(J);
        CoupledSections sections(system.G, system.width, system.law);
        const PassRange range{0, J, length * usual.ks, length * usual.kr};
        double fed = 0;
        for (int m = 0; m < 300; ++m) {
            const double feed = m < 150 ? 0.004 : 0;
            widestPassFunction()(lanes, coefficients, {fed, 0, feed, feed}, range);
            for (std::size_t j = 0; j < J; ++j) {
                h[j] = fed + feed - depth[j];
            }
            QVERIFY(sections.solve(h.data(), u.data()).converged);
            for (std::size_t j = 0; j < J; ++j) {
                depth[j] += u[j] * u[j];
                QVERIFY(within(depth[j], lanes.depth_mm[j], 1e-12));
            }
            fed += feed;
        }
    }

    void everySystemIsSolvedToItsConditions() {
        QVERIFY(areSolved("conditions", {1, 24}, [](int count) { return count + 2; }));
    }

    // Where G is a sum of few products, a step of few columns stands for Newton's, sections that
    // barely touch or let go included.
    void manySectionsOfFewProductsAreSolvedToTheirConditions() {
        QVERIFY(areSolved("few products", {32, 69}, [](int) { return 19; }));
    }

    // Revolution after revolution from the last one's roots, touch and spark-out included.
    void wholeCyclesConverge_data() {
        addColumns<int, double>("sections", "kr");
        for (const int sections : {2, 4, 8, 20, 50, 100}) {
            for (const double kr : {0.0, 7.0, 71.3, 356.0, 2000.0}) {
                QTest::addRow("%d sections, k_r %g", sections, kr) << sections << kr;
            }
        }
    }
    void wholeCyclesConverge() {
        QFETCH(int, sections);
        QFETCH(double, kr);
        ForceLaw law = usual;
        law.kr = kr;
        const auto J = static_cast<std::size_t>(sections);
        const System system = beam(J, law);
        CoupledSections balance(system.G, system.width, system.law);
        std::vector<double> u(J), h(J);
        for (const double runout : {0.0, 0.01}) {
            double fed = 0;
            std::vector<double> depth(J, runout);
            std::fill(u.begin(), u.end(), 0.0);
            for (int m = 0; m < 200; ++m) {
                fed += m < 120 ? 0.0007 : 0;
                for (std::size_t j = 0; j < J; ++j) {
                    h[j] = fed - depth[j];
                }
                const auto outcome = balance.solve(h.data(), u.data());
                QVERIFY2(outcome.converged, qPrintable(QString::number(m)));
                QVERIFY(outcome.iterations <= 40);
                QVERIFY(system.fault(u, h) < 1e-12);
                for (std::size_t j = 0; j < J; ++j) {
                    depth[j] += u[j] * u[j];
                }
            }
        }
    }

    void bruteForceOverAllContactSetsAgrees() {
        const bool held = rc::check("brute force", [] {
            const auto J = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
            System system = randomSystem(J, J + 1);
            system.law.kr = 0;
            const std::vector<double> h = randomLags(J);
            const auto expected = bruteForce(system, h);
            RC_PRE(expected.has_value());
            const Solution solution = solve(system, h);
            RC_ASSERT(solution.outcome.converged);
            for (std::size_t j = 0; j < J; ++j) {
                RC_ASSERT(within(solution.u[j] * solution.u[j], (*expected)[j], 2e-12));
            }
        });
        QVERIFY(held);
    }

    // Strictly monotone, hence one solution: where it starts from does not matter.
    void solutionIsTheSameFromEveryStart() {
        const bool held = rc::check("start", [] {
            const auto J = static_cast<std::size_t>(*rc::gen::inRange(1, 10));
            const System system = randomSystem(J, J);
            const std::vector<double> h = randomLags(J);
            std::vector<double> from;
            for (std::size_t j = 0; j < J; ++j) {
                from.push_back(*rc::gen::element(0.0, 1.0) * logUniform(1e-6, 1));
            }
            const Solution cold = solve(system, h);
            const Solution warm = solve(system, h, from);
            RC_ASSERT(cold.outcome.converged && warm.outcome.converged);
            for (std::size_t j = 0; j < J; ++j) {
                RC_ASSERT(within(cold.u[j] * cold.u[j], warm.u[j] * warm.u[j], 1e-11));
            }
        });
        QVERIFY(held);
    }

    void nothingCutsWithoutALag() {
        const Solution solution = solve(beam(4, usual), {-1e-3, 0, -1e-9, 0}, {0.1, 0.1, 0.1, 0.1});
        QVERIFY(solution.outcome.converged);
        for (const double u : solution.u) {
            QVERIFY(u * u < 1e-12);
        }
    }

    // A neighbour's force can push a section away that would cut alone.
    void sectionIsPushedOutOfContactByItsNeighbour() {
        const System rigid{.G = {1e-4, 1e-4, 1e-4, 1e-4}, .width = {20, 20}, .law = usual};
        const Solution solution = solve(rigid, {0.1, 0.001});
        QVERIFY(solution.outcome.converged);
        QCOMPARE(solution.u[1], 0.0);
        const double alone = closedForm(1e-4, 20, usual, 0.1);
        QVERIFY(within(solution.u[0] * solution.u[0], alone * alone, 1e-12));
        QVERIFY(solve(rigid, {-1, 0.001}).u[1] > 0);
    }

    // A quill: G the same everywhere and singular; equal lags cut as one section of the whole
    // width.
    void sectionsOnAQuillMoveAsOne() {
        for (const ForceLaw& law : {sharp, usual, dull}) {
            const System quill{
                .G = std::vector<double>(36, 5e-5), .width = std::vector<double>(6, 5), .law = law};
            const Solution solution = solve(quill, std::vector<double>(6, 0.004));
            QVERIFY(solution.outcome.converged);
            const double whole = closedForm(5e-5, 30, law, 0.004);
            for (const double u : solution.u) {
                QVERIFY(within(u * u, whole * whole, 1e-12));
            }
        }
    }

    void whatHasNoSolutionIsReported() {
        const Solution pushed = solve({{-1}, {40}, usual}, {0.01});
        QVERIFY(!pushed.outcome.converged);
        QVERIFY(pushed.outcome.residual_mm > 1e-12);
        QVERIFY(!solve(beam(3, usual), {0.01, std::nan(""), 0.01}).outcome.converged);
    }

    void solvingAllocatesNothing_data() {
        QTest::addColumn<int>("sections");
        QTest::addRow("few") << 20;
        QTest::addRow("many") << 60;
    }
    void solvingAllocatesNothing() {
        QFETCH(int, sections);
        const auto J = static_cast<std::size_t>(sections);
        const System system = beam(J, dull);
        CoupledSections balance(system.G, system.width, system.law);
        std::vector<double> u(J), h(J);
        const long long before = allocations::count;
        for (int m = 1; m < 50; ++m) {
            for (std::size_t j = 0; j < J; ++j) {
                h[j] = (j + std::size_t(m)) % 5 == 0 ? -0.001 : 0.0001 * m;
            }
            balance.solve(h.data(), u.data());
        }
        QCOMPARE(static_cast<long long>(allocations::count), before);
    }

    void warmStartTakesFewSteps() {
        const System system = beam(20, usual);
        CoupledSections sections(system.G, system.width, system.law);
        std::vector<double> u(20), h(20), depth(20);
        int steps = 0;
        for (int m = 0; m < 300; ++m) {
            for (std::size_t j = 0; j < 20; ++j) {
                h[j] = 0.002 * (m + 1) - depth[j];
            }
            steps += sections.solve(h.data(), u.data()).iterations;
            for (std::size_t j = 0; j < 20; ++j) {
                depth[j] += u[j] * u[j];
            }
        }
        QVERIFY2(steps < 3 * 300, qPrintable(QString::number(steps)));
    }
};

} // namespace sparkout::test_coupled_sections

SPARKOUT_TEST(test_coupled_sections, TestCoupledSections)
#include "test_coupled_sections.moc"
