// SPDX-License-Identifier: GPL-3.0-or-later
// Radii side by side against each alone, their conditions written out once more.
#include "core/process/coupled_radii.h"
#include "core/process/coupled_sections.h"
#include "core/process/section_influence.h"

#include "core/project/part.h"
#include "tests/core/process/shafts.h"
#include "tests/registry.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

namespace sparkout::test_coupled_radii {

using Row = CoupledRadii::Row;
using Set = CoupledRadii::Set;

constexpr std::size_t radii = CoupledRadii::sideBySide;
constexpr ForceLaw usual{.ks = 30.7, .kr = 71.3, .kt = 45, .mu = 0.3};
constexpr ForceLaw sharp{.ks = 30.7, .kr = 0, .kt = 45, .mu = 0.3};

/// Sections of a stepped shaft, and lags of radii that all of them cut at.
struct System {
    System(std::size_t count, const ForceLaw& forceLaw, std::vector<SupportSpring> rests = {},
           double stiffness = 1)
        : law(forceLaw), width(count, 65.0 / static_cast<double>(count)), lag(count) {
        const ShaftModel shaft{{{60, 22}, {80, 30}, {50, 18}},
                               shafts::E * stiffness,
                               Mounting::centres,
                               4e4 * stiffness,
                               2e4 * stiffness,
                               5e4 * stiffness,
                               std::move(rests)};
        std::vector<double> middles;
        std::mt19937 random(5);
        for (std::size_t j = 0; j < count; ++j) {
            middles.push_back(65 + width[j] * (static_cast<double>(j) + 0.5));
            for (std::size_t k = 0; k < radii; ++k) {
                lag[j].of[k] = 0.01 * static_cast<double>(k + 1)
                               + 1e-5 * static_cast<double>(random() % 1000) / 1000;
            }
        }
        G = Compliance(shaft).rows(middles, middles);
    }
    [[nodiscard]] std::size_t size() const { return width.size(); }
    [[nodiscard]] std::vector<double> lagOf(std::size_t k) const {
        std::vector<double> h;
        for (const Row& row : lag) {
            h.push_back(row.of[k]);
        }
        return h;
    }
    /// The largest |a_j + Σ_l G_jl·f_l − h_j| of a radius [mm].
    [[nodiscard]] double rest(const std::vector<Row>& root, std::size_t k) const {
        long double worst = 0;
        for (std::size_t j = 0; j < size(); ++j) {
            long double r = static_cast<long double>(root[j].of[k]) * root[j].of[k] - lag[j].of[k];
            for (std::size_t l = 0; l < size(); ++l) {
                const long double u = root[l].of[k];
                r += G[j * size() + l] * width[l] * (law.ks * u * u + law.kr * u);
            }
            worst = std::max(worst, std::abs(r));
        }
        return static_cast<double>(worst);
    }
    ForceLaw law;
    std::vector<double> width, G;
    std::vector<Row> lag;
};

/// Where the steps begin: each section in its own balance.
std::vector<Row> start(const System& system) {
    const CoupledSections sections(system.G, system.width, system.law);
    std::vector<Row> root(system.size());
    for (std::size_t k = 0; k < radii; ++k) {
        std::vector<double> u(system.size());
        sections.begin(system.lagOf(k).data(), u.data());
        for (std::size_t j = 0; j < u.size(); ++j) {
            root[j].of[k] = u[j];
        }
    }
    return root;
}

CoupledRadii radiiOf(const System& system, VectorUnit unit = widestUnit()) {
    return {SectionInfluence(system.G, system.size()), system.width, system.law, unit};
}

bool sameBits(const std::vector<Row>& a, const std::vector<Row>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0;
}

class TestCoupledRadii : public QObject {
    Q_OBJECT

private slots:
    void everyRadiusIsInBalance_data() {
        addColumns<int, int, bool, double>("sections", "rests", "isSharp", "stiffness");
        QTest::newRow("a soft shaft") << 20 << 0 << true << 0.003;
        for (const int sections : {8, 20, 200}) {
            for (const int rests : {0, 1, 3}) {
                QTest::addRow("%d, %d rests", sections, rests) << sections << rests << false << 1.0;
                QTest::addRow("%d, %d rests, sharp", sections, rests)
                    << sections << rests << true << 1.0;
            }
        }
    }
    void everyRadiusIsInBalance() {
        QFETCH(int, sections);
        QFETCH(int, rests);
        QFETCH(bool, isSharp);
        QFETCH(double, stiffness);
        const std::vector<SupportSpring> all{{75, 3e4}, {95, 2e4}, {120, 5e4}};
        const System system(static_cast<std::size_t>(sections), isSharp ? sharp : usual,
                            {all.begin(), all.begin() + rests}, stiffness);
        std::vector<Row> root = start(system);
        QVERIFY(radiiOf(system).solve(system.lag.data(), root.data(), Set().set()).all());
        for (std::size_t k = 0; k < radii; ++k) {
            const double rest = system.rest(root, k);
            QVERIFY2(rest <= 2 * CoupledSections::tolerance_mm, qPrintable(QString::number(rest)));
            std::vector<double> alone(system.size());
            CoupledSections one(system.G, system.width, system.law);
            QVERIFY(one.solve(system.lagOf(k).data(), alone.data()).converged);
            for (std::size_t j = 0; j < alone.size(); ++j) {
                QVERIFY(std::abs(alone[j] * alone[j] - root[j].of[k] * root[j].of[k]) <= 1e-12);
            }
        }
    }

    // The forces are not differences, so that what a step leaves by rounding is far below the
    // tolerance: a step from the solution leaves nothing else.
    void whatRoundingLeavesIsFarBelowTheTolerance() {
        for (const double stiffness : {1.0, 0.01}) {
            const System system(200, stiffness < 1 ? sharp : usual, {}, stiffness);
            std::vector<Row> root = start(system);
            CoupledRadii side = radiiOf(system);
            QVERIFY(side.solve(system.lag.data(), root.data(), Set().set()).all());
            QVERIFY(side.solve(system.lag.data(), root.data(), Set().set()).all());
            for (std::size_t k = 0; k < radii; ++k) {
                const double rest = system.rest(root, k);
                QVERIFY2(rest <= 4e-15 * system.lag[0].of[k], qPrintable(QString::number(rest)));
            }
        }
    }

    // The last step is known by its length alone, however soft the shaft.
    void fromWhereverTheStepsBeginTheBalanceHolds() {
        const System system(20, sharp, {}, 0.003);
        std::vector<Row> root = start(system);
        QVERIFY(radiiOf(system).solve(system.lag.data(), root.data(), Set().set()).all());
        for (int i = 0; i <= 120; ++i) {
            const double off = std::pow(10, -1 - 0.06 * i); // in parts of u
            std::vector<Row> other = root;
            for (Row& row : other) {
                for (double& u : row.of) {
                    u *= 1 + off;
                }
            }
            QVERIFY(radiiOf(system).solve(system.lag.data(), other.data(), Set().set()).all());
            for (std::size_t k = 0; k < radii; ++k) {
                QVERIFY(system.rest(other, k) <= 2 * CoupledSections::tolerance_mm);
            }
        }
    }

    void aRadiusComesOutAsItDoesAloneAndWithEveryVectorUnit() {
        const System system(50, usual);
        std::vector<Row> together = start(system), baseline = together;
        QVERIFY(radiiOf(system).solve(system.lag.data(), together.data(), Set().set()).all());
        QVERIFY(radiiOf(system, VectorUnit::baseline)
                    .solve(system.lag.data(), baseline.data(), Set().set())
                    .all());
        QVERIFY(sameBits(together, baseline));
        const std::vector<Row> begun = start(system);
        std::vector<Set> some; // one, and two in the same third or not
        for (std::size_t k = 0; k < radii; ++k) {
            some.push_back(Set().set(k));
            some.push_back(Set().set(k).set((k + 3) % radii));
        }
        for (const Set& asked : some) {
            std::vector<Row> root = begun;
            QCOMPARE(radiiOf(system).solve(system.lag.data(), root.data(), asked), asked);
            for (std::size_t j = 0; j < system.size(); ++j) {
                for (std::size_t k = 0; k < radii; ++k) { // to the bit
                    QVERIFY(root[j].of[k] == (asked[k] ? together : begun)[j].of[k]);
                }
            }
        }
    }

    void whereASectionLetsGoOrNothingIsKnownIsLeftToTheOthers() {
        System system(50, usual);
        for (std::size_t j = 20; j < 30; ++j) {
            system.lag[j].of[2] = -0.05; // the wheel does not reach it
        }
        system.lag[7].of[5] = std::nan("");
        std::vector<Row> root = start(system);
        for (std::size_t j = 0; j < system.size(); ++j) {
            root[j].of[2] = root[j].of[1]; // it has cut before
        }
        Set expected = Set().set();
        expected.reset(2).reset(5);
        QCOMPARE(radiiOf(system).solve(system.lag.data(), root.data(), Set().set()), expected);
        for (const std::size_t k : {0, 1, 3, 4, 6, 7}) {
            QVERIFY(system.rest(root, k) <= 2 * CoupledSections::tolerance_mm);
        }
    }
};

} // namespace sparkout::test_coupled_radii

SPARKOUT_TEST(test_coupled_radii, TestCoupledRadii)
#include "test_coupled_radii.moc"
