// SPDX-License-Identifier: GPL-3.0-or-later
// The compliance of shafts drawn at random: its laws, and a second way to each number.
#include "core/process/system_compliance.h"
#include "tests/core/process/shafts.h"
#include "tests/core/support/dense.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/processor_time.h"
#include "tests/registry.h"

#include <rapidcheck.h>

#include <random>
#include <stop_token>
#include <utility>

namespace sparkout::test_compliance_any_shaft {

using fixtures::close;
using shafts::E;
using shafts::I;

// pick(lo, hi) gives an integer lo <= i < hi
template <class Pick>
ShaftModel anyShaft(Pick pick) {
    ShaftModel model{{}, E, pick(0, 2) == 0 ? Mounting::centres : Mounting::chuck, 0, 0, 0, {}};
    double L = 0;
    for (int n = pick(1, 7); n > 0; --n) {
        model.segments.push_back({double(pick(20, 200)), double(pick(8, 120))});
        L += model.segments.back().length_mm;
    }
    for (double* j : {&model.headstock_n_mm, &model.tailstock_n_mm, &model.wheelHead_n_mm})
        *j = pick(5000, 500000);
    for (int n = pick(0, 4); n > 0; --n)
        model.rests.push_back({L * pick(0, 1001) / 1000, double(pick(0, 1000000))});
    return model;
}

const auto fromRapidcheck = [](int lo, int hi) { return *rc::gen::inRange(lo, hi); };

ShaftModel shaftOfSeed(unsigned seed) {
    std::mt19937 engine(seed);
    return anyShaft([&](int lo, int hi) { return lo + int(engine() % unsigned(hi - lo)); });
}

// The independent second way: Euler-Bernoulli finite elements (exact at the nodes) of the shaft on
// its springs. Answers G(x_i,x_j) for all nodes; degrees of freedom are deflection and slope of
// each node.
dense::Matrix finiteElements(const ShaftModel& model, const std::vector<double>& nodes) {
    const std::size_t n = nodes.size();
    dense::Matrix K(2 * n, std::vector<double>(2 * n));
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double l = nodes[i + 1] - nodes[i];
        const double middle = nodes[i] + l / 2;
        double end = 0;
        const auto segment =
            std::find_if(model.segments.begin(), model.segments.end(),
                         [&](const BeamSegment& s) { return (end += s.length_mm) > middle; });
        const double k[4][4] = {{12, 6 * l, -12, 6 * l},
                                {6 * l, 4 * l * l, -6 * l, 2 * l * l},
                                {-12, -6 * l, 12, -6 * l},
                                {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
        const double factor = model.youngsModulus_n_mm2 * I(segment->diameter_mm) / (l * l * l);
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t q = 0; q < 4; ++q)
                K[2 * i + p][2 * i + q] += factor * k[p][q];
    }
    K[0][0] += model.headstock_n_mm;
    if (model.mounting == Mounting::centres)
        K[2 * n - 2][2 * n - 2] += model.tailstock_n_mm;
    for (const SupportSpring& rest : model.rests) {
        const auto found = std::find(nodes.begin(), nodes.end(), rest.position_mm);
        const auto node = std::size_t(2 * (found - nodes.begin()));
        K[node][node] += rest.stiffness_n_mm;
    }
    if (model.mounting == Mounting::chuck) { // no slope at the chuck face
        for (std::size_t i = 0; i < 2 * n; ++i)
            K[1][i] = K[i][1] = i == 1;
    }
    const dense::Matrix inverse = dense::inverse(K);
    dense::Matrix G(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            G[i][j] = 1 / model.wheelHead_n_mm + inverse[2 * i][2 * j];
    return G;
}

class TestComplianceAnyShaft : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(10000); }

    void influenceIsSymmetricToTheLastBit() {
        QVERIFY(rc::check("G(x,s) = G(s,x)", [] {
            const Compliance shaft(anyShaft(fromRapidcheck));
            const double x = shaft.length() * fromRapidcheck(0, 1001) / 1000;
            const double s = shaft.length() * fromRapidcheck(0, 1001) / 1000;
            RC_ASSERT(shaft.between(x, s) == shaft.between(s, x));
            RC_ASSERT(std::isfinite(shaft.between(x, s)));
        }));
    }

    void influenceMatrixIsPositiveDefinite() {
        QVERIFY(rc::check("the matrix G(x_i,x_j) has a Cholesky factor", [] {
            const Compliance shaft(anyShaft(fromRapidcheck));
            dense::Matrix G(4, std::vector<double>(4));
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    G[i][j] = shaft.between(shaft.length() * (double(i) + 0.5) / 4,
                                            shaft.length() * (double(j) + 0.5) / 4);
            RC_ASSERT(dense::isPositiveDefinite(G));
        }));
    }

    void partsAddUpToTheCompliance() {
        QVERIFY(rc::check("the sum of the parts is gamma(x)", [] {
            const Compliance shaft(anyShaft(fromRapidcheck));
            const double x = shaft.length() * fromRapidcheck(0, 1001) / 1000;
            const ComplianceParts p = shaft.partsAt(x);
            RC_ASSERT(close(p.wheelHead + p.headstock + p.tailstock + p.bending + p.rests,
                            shaft.at(x), 1e-9));
            RC_ASSERT(p.headstock >= 0 && p.tailstock >= 0 && p.bending >= 0 && p.rests <= 0);
        }));
    }

    // Cut into many segments a shaft is summed up in another way; so is one with many rests.
    void manySegmentsAndRestsAreTheSameShaft() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            ShaftModel model = shaftOfSeed(seed);
            const Compliance singly(model);
            ShaftModel cut = model;
            cut.segments.clear();
            for (const BeamSegment& segment : model.segments) {
                for (int i = 0; i < 150; ++i) {
                    cut.segments.push_back({segment.length_mm / 150, segment.diameter_mm});
                }
            }
            const Compliance running(cut);
            ShaftModel free = model; // its rests may leave little of it
            free.rests.clear();
            const double L = singly.length();
            const double scale = std::max(Compliance(free).at(L / 2), Compliance(free).at(L));
            for (const double x : {0.0, 0.11 * L, 0.37 * L, 0.5 * L, 0.83 * L, L}) {
                for (const double s : {0.02 * L, 0.37 * L, 0.9 * L}) {
                    QVERIFY(fixtures::within(running.between(x, s), singly.between(x, s),
                                             1e-12 * scale));
                    QVERIFY(running.between(x, s) == running.between(s, x));
                    QVERIFY(fixtures::within(running.mean(x, s / 2, s), singly.mean(x, s / 2, s),
                                             1e-12 * scale));
                }
            }
            const std::vector<double> places{0.1 * L, 0.4 * L, L};
            const std::vector<double> rows = running.rows(places, places);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                QVERIFY(rows[i] == running.between(places[i / 3], places[i % 3]));
            }
        }
    }

    // 1,000 of each: what a run and the drawing ask for, within half a second (four times that on a
    // busy machine); a stop ends it at once.
    void aThousandSegmentsAndRestsTakeHalfASecond() {
        Project p = fixtures::restedShaft();
        p.sections = 20;
        double start_ms = processorTime_ms();
        const auto took_ms = [&start_ms] {
            const double since_ms = std::exchange(start_ms, processorTime_ms());
            return start_ms - since_ms;
        };
        const std::vector<CompliantPoint> points = compliantPoints(p);
        const double points_ms = took_ms();
        const std::vector<CompliantPlace> along = complianceAlong(p, 241);
        const double along_ms = took_ms();
        qInfo("sections %.0f ms, along the shaft %.0f ms", points_ms, along_ms);
        QVERIFY(points_ms < 2000 && along_ms < 2000);
        QCOMPARE(points.size(), 20u);
        for (const CompliantPoint& point : points) { // between a rigid shaft's and a free one's
            QVERIFY(point.gamma_mm_n > 1 / 50e3 && point.gamma_mm_n < 1e-3);
        }
        const auto stop = std::make_unique<std::stop_source>(); // on the stack GCC 12 warns of it
        stop->request_stop();
        took_ms();
        QCOMPARE(compliantPoints(p, stop->get_token()).size(), 20u);
        QVERIFY(took_ms() < 200);
    }

    void finiteElementsOfTheShaftSayTheSame_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 60; ++seed)
            QTest::addRow("shaft %u", seed) << seed;
    }
    void finiteElementsOfTheShaftSayTheSame() {
        QFETCH(unsigned, seed);
        const ShaftModel model = shaftOfSeed(seed);
        const Compliance shaft(model);
        std::vector<double> nodes{0};
        for (const BeamSegment& segment : model.segments) {
            const double from = nodes.back();
            nodes.insert(nodes.end(), {from + segment.length_mm / 3, from + segment.length_mm});
        }
        for (const SupportSpring& rest : model.rests)
            nodes.push_back(rest.position_mm);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        const dense::Matrix expected = finiteElements(model, nodes);
        double largest = 0;
        for (const std::vector<double>& row : expected)
            largest = std::max(largest, *std::max_element(row.begin(), row.end()));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t j = 0; j < nodes.size(); ++j)
                QVERIFY(std::abs(shaft.between(nodes[i], nodes[j]) - expected[i][j])
                        <= 1e-8 * largest);
    }

    void meanEqualsDenseQuadrature_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 20; ++seed)
            QTest::addRow("shaft %u", seed) << seed;
    }
    void meanEqualsDenseQuadrature() {
        QFETCH(unsigned, seed);
        const Compliance shaft(shaftOfSeed(seed));
        const double L = shaft.length();
        const int n = 4000;
        using Interval = std::pair<double, double>;
        for (const auto& [from, to] :
             {Interval{0, L}, Interval{0.21 * L, 0.67 * L}, Interval{0.5 * L, 0.52 * L}}) {
            for (const double x : {0.0, 0.13 * L, 0.515 * L, 0.9 * L, L}) {
                double sum = 0; // midpoint rule
                for (int i = 0; i < n; ++i)
                    sum += shaft.between(x, from + (to - from) * (i + 0.5) / n);
                QVERIFY(close(shaft.mean(x, from, to), sum / n, 1e-6));
            }
        }
    }

    void meanOverNoLengthIsTheInfluenceAtThatPoint() {
        const Compliance shaft(shaftOfSeed(3));
        const double L = shaft.length();
        QCOMPARE(shaft.mean(0.3 * L, 0.6 * L, 0.6 * L), shaft.between(0.3 * L, 0.6 * L));
        QVERIFY(close(shaft.mean(0.3 * L, 0.6 * L, 0.6 * L + 1e-6), shaft.between(0.3 * L, 0.6 * L),
                      1e-7));
    }
};

} // namespace sparkout::test_compliance_any_shaft

SPARKOUT_TEST(test_compliance_any_shaft, TestComplianceAnyShaft)
#include "test_compliance_any_shaft.moc"
