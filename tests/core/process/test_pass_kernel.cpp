// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/pass_kernel.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <cstring>
#include <random>

namespace sparkout::test_pass_kernel {

/// Random lanes at one width of cut, as wide as inputs can be: γ 1e-9…1 mm/N, b·k_s and b·k_r over
/// six decades or zero, depths up to some mm, lanes in contact and lanes out of it.
struct RandomPass {
    Lanes lanes;
    LaneCoefficients coefficients;
    std::vector<double> gamma;
    PassFeed feed;
    PassRange range;

    RandomPass(std::mt19937_64& engine, std::size_t first, std::size_t count,
               std::size_t behind = 3)
        : lanes(first + count + behind)
        , coefficients(first + count + behind)
        , gamma(first + count + behind) {
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(engine);
        };
        const auto decades = [&](double low, double high) {
            return std::pow(10, uniform(low, high));
        };
        range = {first, count, decades(-1, 5), uniform(0, 1) < 0.2 ? 0 : decades(-1, 5)};
        feed.base = uniform(0, 1) < 0.2 ? 0 : decades(-6, 0);
        if (uniform(0, 1) < 0.5) {
            feed.offset = decades(-6, -2);
            feed.rate = decades(-6, -1);
            feed.cap = decades(-5, -1);
        }
        if (uniform(0, 1) < 0.3) {
            feed.drift = decades(-6, -1);
            feed.most = feed.base + decades(-6, 0);
        }
        for (std::size_t i = 0; i < lanes.depth_mm.size(); ++i) {
            gamma[i] = decades(-9, 0);
            coefficients.set(i, gamma[i], range.bks, range.bkr);
            lanes.share[i] = uniform(0, 1);
            const double below = feed.base * (1 - decades(-16, 0));
            lanes.depth_mm[i] = uniform(0, 1) < 0.25 ? uniform(0, 2) : below;
            lanes.peakRoot[i] = uniform(0, 1) < 0.5 ? 0 : decades(-3, 1);
            lanes.root[i] = -1;
            lanes.rootSum[i] = uniform(0, 1) < 0.5 ? 0 : decades(-3, 2);
        }
        if (uniform(0, 1) < 0.3) {
            feed.waveCos_mm = uniform(-1e-3, 1e-3);
            feed.waveSin_mm = uniform(-1e-3, 1e-3);
            for (std::size_t i = 0; i < lanes.depth_mm.size(); ++i) {
                lanes.waveCos.push_back(uniform(-1, 1));
                lanes.waveSin.push_back(uniform(-1, 1));
            }
        }
    }
    /// h as the kernel's page defines it.
    [[nodiscard]] double gap(std::size_t lane) const {
        const double ramp = feed.base + feed.offset + feed.rate * lanes.share[lane];
        const double fed = std::min(ramp, feed.base + feed.cap);
        const double there = std::min(fed + feed.drift * lanes.share[lane], feed.most);
        const double wave = lanes.waveCos.empty() ? 0
                                                  : feed.waveCos_mm * lanes.waveCos[lane]
                                                        + feed.waveSin_mm * lanes.waveSin[lane];
        return there + wave - lanes.depth_mm[lane];
    }
};

bool sameBits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

class TestPassKernel : public QObject {
    Q_OBJECT

private slots:
    void baselineIsAlwaysSupportedAndTheWidestIsSupported() {
        QVERIFY(isSupported(VectorUnit::baseline));
        bool found = false;
        for (const VectorUnit unit : {VectorUnit::baseline, VectorUnit::avx2}) {
            found |= isSupported(unit) && passFunction(unit) == widestPassFunction();
        }
        QVERIFY(found);
    }

    void vectorUnitsAgreeToTheLastBit() {
        if (!isSupported(VectorUnit::avx2)) {
            QSKIP("this processor has no AVX2");
        }
        std::mt19937_64 engine(1);
        for (int round = 0; round < 50; ++round) {
            for (std::size_t count = 1; count <= 40; ++count) {
                RandomPass wide(engine, static_cast<std::size_t>(round % 5), count);
                RandomPass narrow = wide;
                // Several passes in a row, so that a difference of a bit has time to grow.
                for (int pass = 0; pass < 4; ++pass) {
                    const double a = passFunction(VectorUnit::avx2)(wide.lanes, wide.coefficients,
                                                                    wide.feed, wide.range);
                    const double b = passFunction(VectorUnit::baseline)(
                        narrow.lanes, narrow.coefficients, narrow.feed, narrow.range);
                    QVERIFY(std::memcmp(&a, &b, sizeof a) == 0);
                    QVERIFY(sameBits(wide.lanes.depth_mm, narrow.lanes.depth_mm));
                    QVERIFY(sameBits(wide.lanes.root, narrow.lanes.root));
                    QVERIFY(sameBits(wide.lanes.rootSum, narrow.lanes.rootSum));
                    QVERIFY(sameBits(wide.lanes.peakRoot, narrow.lanes.peakRoot));
                    wide.feed.base = narrow.feed.base = wide.feed.base * 1.01;
                }
            }
        }
    }

    // pass_kernel.h: the multiplied form is off by at most ε·C/A in √a. On top of it come the
    // relative roundings of the coefficients and of the operations, ten at most.
    void rootIsTheNonCancellingFormsToTheStatedBound_data() { everyUnit(); }
    void rootIsTheNonCancellingFormsToTheStatedBound() {
        QFETCH(VectorUnit, unit);
        if (!isSupported(unit)) {
            QSKIP("this processor has no such unit");
        }
        std::mt19937_64 engine(2);
        int inContact = 0;
        for (int round = 0; round < 5000; ++round) {
            RandomPass pass(engine, 2, 1 + static_cast<std::size_t>(round) % 40);
            const Lanes before = pass.lanes;
            RandomPass old = pass;
            passFunction(unit)(pass.lanes, pass.coefficients, pass.feed, pass.range);
            for (std::size_t i = 2; i < 2 + pass.range.count; ++i) {
                const long double h = old.gap(i);
                if (h <= 0) {
                    continue;
                }
                ++inContact;
                const long double A = 1 + static_cast<long double>(pass.gamma[i]) * pass.range.bks;
                const long double C = static_cast<long double>(pass.gamma[i]) * pass.range.bkr;
                const long double exact = 2 * h / (C + std::sqrt(C * C + 4 * A * h));
                const double bound = fixtures::epsilon * static_cast<double>(C / A + 10 * exact);
                const double u = pass.lanes.root[i];
                QVERIFY2(u >= 0 && std::abs(static_cast<double>(u - exact)) <= bound,
                         qPrintable(QString("round %1 lane %2: √a %3, exact %4")
                                        .arg(round)
                                        .arg(i)
                                        .arg(u)
                                        .arg(double(exact))));
                const double a = pass.lanes.depth_mm[i] - before.depth_mm[i];
                // a itself: u² and the last bit of the depth it is added to.
                QVERIFY(std::abs(a - u * u)
                        <= fixtures::epsilon * (pass.lanes.depth_mm[i] + u * u));
            }
        }
        QVERIFY(inContact > 50'000);
    }

    void radiusOutOfContactIsNotTouched_data() { everyUnit(); }
    void radiusOutOfContactIsNotTouched() {
        QFETCH(VectorUnit, unit);
        if (!isSupported(unit)) {
            QSKIP("this processor has no such unit");
        }
        std::mt19937_64 engine(3);
        for (int round = 0; round < 2000; ++round) {
            RandomPass pass(engine, 1, 1 + static_cast<std::size_t>(round) % 40);
            for (std::size_t i = 0; i < pass.lanes.depth_mm.size(); ++i) {
                // Exactly at the wheel (h = 0), or below it by as little as one bit.
                pass.lanes.depth_mm[i] += pass.gap(i);
                pass.lanes.depth_mm[i] = std::max(0.0, pass.lanes.depth_mm[i]);
                while (pass.gap(i) > 0) {
                    pass.lanes.depth_mm[i] = std::nextafter(pass.lanes.depth_mm[i], 1e9);
                }
                pass.lanes.depth_mm[i] += i % 3 == 0 ? 0 : std::pow(0.1, double(i % 17));
            }
            const Lanes before = pass.lanes;
            const double largest =
                passFunction(unit)(pass.lanes, pass.coefficients, pass.feed, pass.range);
            QCOMPARE(largest, 0.0);
            QVERIFY(sameBits(before.depth_mm, pass.lanes.depth_mm));
            QVERIFY(sameBits(before.rootSum, pass.lanes.rootSum));
            QVERIFY(sameBits(before.peakRoot, pass.lanes.peakRoot));
            for (std::size_t i = 1; i < 1 + pass.range.count; ++i) {
                QVERIFY(pass.lanes.root[i] == 0.0);
            }
        }
    }

    void lanesOutsideTheRangeAreNotTouched_data() { everyUnit(); }
    void lanesOutsideTheRangeAreNotTouched() {
        QFETCH(VectorUnit, unit);
        if (!isSupported(unit)) {
            QSKIP("this processor has no such unit");
        }
        std::mt19937_64 engine(4);
        for (std::size_t count = 0; count <= 40; ++count) {
            RandomPass pass(engine, count % 7, count, 9);
            const Lanes before = pass.lanes;
            passFunction(unit)(pass.lanes, pass.coefficients, pass.feed, pass.range);
            for (std::size_t i = 0; i < before.depth_mm.size(); ++i) {
                if (i < pass.range.first || i >= pass.range.first + count) {
                    QCOMPARE(pass.lanes.depth_mm[i], before.depth_mm[i]);
                    QCOMPARE(pass.lanes.root[i], before.root[i]);
                    QCOMPARE(pass.lanes.rootSum[i], before.rootSum[i]);
                    QCOMPARE(pass.lanes.peakRoot[i], before.peakRoot[i]);
                }
            }
        }
    }

    void rootsAddUpAndTheLargestIsKeptAndReturned() {
        std::mt19937_64 engine(5);
        for (int round = 0; round < 2000; ++round) {
            RandomPass pass(engine, 0, 1 + static_cast<std::size_t>(round) % 40, 0);
            const Lanes before = pass.lanes;
            const double largest =
                widestPassFunction()(pass.lanes, pass.coefficients, pass.feed, pass.range);
            double expected = 0;
            for (std::size_t i = 0; i < pass.range.count; ++i) {
                const double u = pass.lanes.root[i];
                expected = std::max(expected, u);
                QCOMPARE(pass.lanes.rootSum[i], before.rootSum[i] + u);
                QCOMPARE(pass.lanes.peakRoot[i], std::max(before.peakRoot[i], u));
            }
            QCOMPARE(largest, expected);
        }
    }

    // To the last bit what it would be with the force of every lane at hand: over passes of one
    // section or several, at widths that change, deeper and shallower.
    void thePeakOfASectionIsTheLargestForceOfItsLanes() {
        std::mt19937_64 engine(8);
        int raised = 0, kept = 0;
        for (int round = 0; round < 300; ++round) {
            const std::size_t radii = 1 + static_cast<std::size_t>(round) % 13;
            const std::size_t sections = 1 + static_cast<std::size_t>(round) % 5;
            RandomPass pass(engine, 0, radii * sections, 0);
            std::fill(pass.lanes.peakRoot.begin(), pass.lanes.peakRoot.end(), 0.0);
            PeakForces peaks(sections, radii);
            std::vector<double> plain(sections);
            for (int i = 0; i < 30; ++i) {
                const auto drawn = [&](std::size_t count) {
                    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine);
                };
                const std::size_t first = drawn(sections), count = 1 + drawn(sections - first);
                const double width = 1 + 0.5 * static_cast<double>(drawn(3));
                const PassRange range{first * radii, count * radii, pass.range.bks * width,
                                      pass.range.bkr * width};
                for (std::size_t lane = 0; lane < pass.gamma.size(); ++lane) {
                    pass.coefficients.set(lane, pass.gamma[lane], range.bks, range.bkr);
                }
                pass.feed.base *= 1 + 0.001 * static_cast<double>(drawn(4));
                peaks.passBegins(pass.lanes, range, first, count);
                widestPassFunction()(pass.lanes, pass.coefficients, pass.feed, range);
                for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
                    const double u = pass.lanes.root[lane], a = u * u;
                    double& peak = plain[lane / radii];
                    const double force = range.bks * a + range.bkr * u;
                    raised += force > peak ? 1 : 0;
                    kept += force < peak ? 1 : 0;
                    peak = std::max(peak, force);
                }
                for (std::size_t section = 0; section < sections; ++section) {
                    QVERIFY(peaks.of(pass.lanes, section) == plain[section]);
                }
            }
        }
        QVERIFY(raised > 1000 && kept > 1000);
    }

    // t_П = base + min(offset + rate·share, cap): a rigid system (A = 1, C = 0) cuts exactly that
    // deep. √ and square round once each: two ε.
    void infeedOfAPassIsTheCappedRamp() {
        Lanes lanes(4);
        LaneCoefficients rigid(4);
        for (std::size_t i = 0; i < 4; ++i) {
            rigid.set(i, 0, 1000, 1000);
            lanes.share[i] = (static_cast<double>(i) + 1) / 4;
        }
        widestPassFunction()(lanes, rigid, {0.5, 0.01, 0.04, 0.035}, {0, 4, 1000, 1000});
        const double expected[] = {0.52, 0.53, 0.535, 0.535};
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(fixtures::close(lanes.depth_mm[i], expected[i], 3 * fixtures::epsilon));
        }
    }

    // shared/vectors: linear law, γK = 2, two radii 20 µm apart, both at the same t_П, 5 µm a
    // revolution. The table has five decimals of a µm.
    void outOfRoundBlankLosesItsRunoutAsPublished() {
        const std::vector<std::pair<int, double>> table{{1, 18.33333}, {2, 15.55556}, {4, 8.02469},
                                                        {5, 5.34979},  {6, 3.56653},  {8, 1.58512},
                                                        {10, .70450},  {15, .09277},  {20, .01222}};
        Lanes lanes(2);
        lanes.depth_mm[1] = 0.020;
        LaneCoefficients coefficients(2);
        coefficients.set(0, 2e-3, 1000, 0);
        coefficients.set(1, 2e-3, 1000, 0);
        int done = 0;
        for (const auto& [revolutions, runout_um] : table) {
            while (done < revolutions) {
                ++done;
                widestPassFunction()(lanes, coefficients, {.base = 0.005 * done}, {0, 2, 1000, 0});
            }
            QVERIFY2(fixtures::within((lanes.depth_mm[1] - lanes.depth_mm[0]) * 1000, runout_um,
                                      0.50001e-5),
                     qPrintable(QString("after %1 revolutions").arg(revolutions)));
        }
    }

    // The corner of the allowed inputs where the multiplied form would lose 1e-10 mm: k_r/k_s =
    // 1e8.
    void veryDullWheelOnVerySlowWorkStillBalances() {
        const double bks = 1e-3, bkr = 1e5;
        for (const double gamma : {1e-7, 1e-5, 1e-3, 0.1}) {
            Lanes lanes(8);
            LaneCoefficients coefficients(8);
            for (std::size_t i = 0; i < 8; ++i) {
                coefficients.set(i, gamma, bks, bkr);
                lanes.share[i] = double(i + 1) / 8;
            }
            for (int m = 0; m < 200; ++m) {
                const Lanes before = lanes;
                const PassFeed feed{0.005 * m, 0, 0.005, 0.005};
                widestPassFunction()(lanes, coefficients, feed, {0, 8, bks, bkr});
                for (std::size_t i = 0; i < 8; ++i) {
                    const long double u = lanes.root[i];
                    const long double h = feed.base + 0.005 * lanes.share[i] - before.depth_mm[i];
                    const long double residual = u * u + gamma * (bks * u * u + bkr * u) - h;
                    QVERIFY2(std::abs(residual) < 1e-12L,
                             qPrintable(QString::number(double(residual))));
                }
            }
        }
    }

private:
    static void everyUnit() {
        QTest::addColumn<VectorUnit>("unit");
        QTest::newRow("baseline") << VectorUnit::baseline;
        QTest::newRow("AVX2") << VectorUnit::avx2;
    }
};

} // namespace sparkout::test_pass_kernel

SPARKOUT_TEST(test_pass_kernel, TestPassKernel)
#include "test_pass_kernel.moc"
