// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/section_influence.h"

#include "core/project/part.h"
#include "tests/core/process/shafts.h"
#include "tests/registry.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace sparkout::test_section_influence {

/// G at the middles of `count` slices from `from` to `to` mm of a shaft.
std::vector<double> influence(const ShaftModel& shaft, int count, double from, double to) {
    std::vector<double> middles;
    for (int j = 0; j < count; ++j) {
        middles.push_back(from + (j + 0.5) / count * (to - from));
    }
    return Compliance(shaft).rows(middles, middles);
}

ShaftModel stepped(Mounting mounting, std::vector<SupportSpring> rests = {}) {
    return {{{60, 22}, {80, 30}, {50, 18}}, shafts::E, mounting, 4e4, 2e4, 5e4, std::move(rests)};
}

/// G·f, long; and with every number's magnitude.
std::pair<long double, long double> product(const std::vector<double>& G, std::size_t size,
                                            std::size_t j, const std::vector<double>& f) {
    long double sum = 0, magnitude = 0;
    for (std::size_t l = 0; l < size; ++l) {
        const long double term = static_cast<long double>(G[j * size + l]) * f[l];
        sum += term;
        magnitude += std::abs(term);
    }
    return {sum, magnitude};
}

/// How far a product and a solution are from what they should be, in parts of what the forces do
/// without signs; a solution that is not 0 where it should be is no solution.
std::pair<double, double> faults(const std::vector<double>& G, std::size_t size) {
    SectionInfluence influence(G, size);
    const double largest = *std::max_element(G.begin(), G.end());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    double productFault = 0, solutionFault = 0;
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<double> f, added, side, made(size);
        std::vector<std::ptrdiff_t> free;
        std::vector<bool> isFree;
        for (std::size_t j = 0; j < size; ++j) {
            f.push_back(trial % 2 == 0 ? share(random) : share(random) - 0.5);
            added.push_back(largest * std::pow(10, -4 * share(random)));
            side.push_back(share(random) - 0.5);
            isFree.push_back(share(random) < 0.8);
            if (isFree.back()) {
                free.push_back(static_cast<std::ptrdiff_t>(j));
            }
        }
        influence.multiply(f.data(), made.data());
        std::vector<double> x = side;
        influence.solve(added.data(), free, x.data());
        long double scale = 0, far = 0, solved = 1, unsolved = 0;
        for (std::size_t j = 0; j < size; ++j) {
            const auto [sum, magnitude] = product(G, size, j, f);
            scale = std::max(scale, magnitude);
            far = std::max(far, std::abs(sum - made[j]));
            const auto [given, large] = product(G, size, j, x);
            solved = std::max(solved, large);
            unsolved =
                std::max(unsolved, isFree[j]   ? std::abs(given + added[j] * x[j] - side[j])
                                   : x[j] == 0 ? 0
                                               : std::numeric_limits<long double>::infinity());
        }
        productFault = std::max(productFault, static_cast<double>(far / scale));
        solutionFault = std::max(solutionFault, static_cast<double>(unsolved / solved));
    }
    return {productFault, solutionFault};
}

class TestSectionInfluence : public QObject {
    Q_OBJECT

private slots:
    void aShaftIsCountedInTimeProportionalToItsSectionsAsByTheWholeMatrix_data() {
        addColumns<int, int>("sections", "shaft");
        for (const int sections : {8, 20, 51, 200}) {
            for (int shaft = 0; shaft < 6; ++shaft) {
                QTest::addRow("%d of %d", shaft, sections) << sections << shaft;
            }
        }
    }
    void aShaftIsCountedInTimeProportionalToItsSectionsAsByTheWholeMatrix() {
        QFETCH(int, sections);
        QFETCH(int, shaft);
        const ShaftModel models[] = {
            stepped(Mounting::centres),
            stepped(Mounting::chuck),
            stepped(Mounting::centres, {{100, 3e4}}),
            stepped(Mounting::centres, {{75, 3e4}, {110, 1e5}}),
            stepped(Mounting::chuck, {{80, 3e4}, {95, 2e4}, {120, 5e4}}),
            shafts::uniform(400, 12, Mounting::centres, shafts::rigid, shafts::rigid,
                            shafts::rigid),
        };
        const double to = shaft == 5 ? 390 : 130;
        const auto size = static_cast<std::size_t>(sections);
        const auto G = influence(models[shaft], sections, shaft == 5 ? 10 : 65, to);
        QVERIFY(SectionInfluence(G, size).isShort());
        const auto [product, solution] = faults(G, size);
        QVERIFY2(product <= SectionInfluence::mostError, qPrintable(QString::number(product)));
        QVERIFY2(solution <= 1e-12, qPrintable(QString::number(solution)));
    }

    void whatAllSectionsShareIsOne() { // a quill: they move together; and nothing yields
        constexpr std::size_t size = 64;
        for (const double gamma : {1e-5, 0.0}) {
            const SectionInfluence influence(std::vector<double>(size * size, gamma), size);
            QVERIFY(influence.isShort());
            std::vector<double> made(size);
            influence.multiply(std::vector<double>(size, 1.0).data(), made.data());
            for (const double value : made) {
                QVERIFY(std::abs(value - size * gamma) <= 1e-14 * size * gamma);
            }
        }
    }

    void aMatrixOfAnotherFormGoesTheUsualWay() {
        std::mt19937 random(2);
        std::normal_distribution<double> number;
        constexpr std::size_t size = 40;
        std::vector<double> root, G;
        for (std::size_t i = 0; i < size * size; ++i) {
            root.push_back(number(random));
        }
        for (std::size_t i = 0; i < size * size; ++i) { // root·rootᵀ
            G.push_back(std::inner_product(&root[i / size * size], &root[i / size * size] + size,
                                           &root[i % size * size], 0.0));
        }
        QVERIFY(!SectionInfluence(G, size).isShort());
        const auto [product, solution] = faults(G, size);
        QVERIFY(product <= 1e-15);
        QVERIFY(solution <= 1e-12);
        constexpr std::size_t few = SectionInfluence::fewestSections - 1;
        const auto small = influence(stepped(Mounting::centres), few, 65, 130);
        QVERIFY(!SectionInfluence(small, few).isShort());
    }
};

} // namespace sparkout::test_section_influence

SPARKOUT_TEST(test_section_influence, TestSectionInfluence)
#include "test_section_influence.moc"
