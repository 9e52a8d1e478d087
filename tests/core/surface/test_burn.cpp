// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/burn.h"

#include "core/surface/burn_table.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <array>

namespace sparkout::test_burn {

using fixtures::anyCutting;
using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::holds;
using fixtures::within;

/// The steel of the vectors' page: 40Х at 200 °C, μ 0.4, on the full-law case.
Project hotSteel() {
    Project p = fixtures::plunge();
    p.material->conductivity_w_mk = 42.7;
    p.material->diffusivity_mm2_s = 10.818;
    p.material->friction = 0.4;
    return p;
}

/// ∫ f from a to b by Gauss' rule with five points on each of n pieces.
template <class Function>
double integral(const Function& f, double a, double b, int n) {
    constexpr std::array<double, 3> at{0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665,
                                           0.2369268850561891};
    const double half = (b - a) / n / 2;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double middle = a + (2 * i + 1) * half;
        sum += weight[0] * f(middle);
        for (std::size_t k : {1, 2}) {
            sum += weight[k] * (f(middle - at[k] * half) + f(middle + at[k] * half));
        }
    }
    return sum * half;
}

/// Rise at depth h after a surface has taken the flux q for the time t, added up from the heat of
/// each moment: T = ∫ q/λ·√(Ω/(π·s))·e^(−h²/(4Ωs)) ds; s = v² takes the root away.
double riseByMoments(double q, double time, double lambda, double Omega, double h) {
    return integral(
        [&](double v) {
            return 2 * q / lambda * std::sqrt(Omega / std::numbers::pi)
                   * std::exp(-h * h / (4 * Omega * v * v));
        },
        0, std::sqrt(time), 4000);
}

/// Jaeger's band of the length L, moving with V: the surface at its trailing edge, where it is
/// hottest. T = q/(πλ)·∫ e^(ks)·K₀(ks) ds, k = V/(2Ω); s = v² takes the logarithm away.
double riseUnderBand(double q, double L, double V, double lambda, double Omega) {
    const double k = V / (2 * Omega);
    return q / (std::numbers::pi * lambda)
           * integral(
               [&](double v) {
                   const double y = k * v * v;
                   const double K0 = // times e^y; far out its series, to 1e-9
                       y < 300 ? std::exp(y) * std::cyl_bessel_k(0, y)
                               : std::sqrt(std::numbers::pi / (2 * y))
                                     * (1 - 1 / (8 * y) + 9 / (128 * y * y));
                   return 2 * v * K0;
               },
               0, std::sqrt(L), 2000);
}

class TestBurn : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(2000); }

    // Values of 60-digit arithmetic; the first three are the vectors' (0.5641896, 0.1996412,
    // 0.0502545).
    void ierfcIsRightToALastBitOrTwo_data() {
        addColumns<double, double>("x", "value");
        const std::pair<double, double> rows[] = {
            {0, 5.6418958354775628695e-1},      {0.5, 1.9964122837424566589e-1},
            {1, 5.0254541660012221011e-2},      {1e-8, 5.6418957354775634337e-1},
            {0.1, 4.6982209499629695586e-1},    {1.5, 8.622864324780776366e-3},
            {2, 9.7802271495149525267e-4},      {3, 3.3550349776176028269e-6},
            {4, 1.8221417582127159331e-9},      {4.999, 1.4967961477841066926e-13},
            {5.001, 1.4660464295308629182e-13}, {6, 1.7466416874697627613e-18},
            {8, 6.909624589357963465e-31},      {12, 5.6125089023169516201e-66},
            {20, 1.3456148718190447178e-177},   {25.5, 1.7231722792403779789e-286}};
        for (const auto& [x, value] : rows) {
            QTest::addRow("%g", x) << x << value;
        }
    }
    void ierfcIsRightToALastBitOrTwo() {
        QFETCH(double, x);
        QFETCH(double, value);
        QVERIFY(close(ierfc(x), value, 1e-15));
    }

    // ierfc' = −erfc, everywhere, across the seam between the two forms too.
    void ierfcFallsByErfc() {
        for (double x = 0.01; x < 20; x += 0.0831) {
            const double step = 1e-3 / (1 + x);
            const double fall = integral([](double t) { return std::erfc(t); }, x, x + step, 1);
            QVERIFY(within(ierfc(x) - ierfc(x + step), fall, 4e-16 * ierfc(x) + 1e-12 * fall));
        }
    }

    void inverseOfIerfcBringsTheValueBack() {
        QCOMPARE(inverseIerfc(std::numbers::inv_sqrtpi), 0.0);
        QCOMPARE(inverseIerfc(1), 0.0);
        for (double value = 0.5641; value > 1e-290; value *= 0.77) {
            const double x = inverseIerfc(value);
            QVERIFY(close(ierfc(x), value, 1e-15 * (4 + 2 * x * x)));
        }
        for (const double tiny : {1e-12, 1e-9, 1e-5}) { // T a trifle above U: h_d a trifle
            QVERIFY(
                within(inverseIerfc(std::numbers::inv_sqrtpi - tiny), tiny, 3e-16 + tiny * tiny));
        }
    }

    // shared/vectors, to the digits printed
    void vectorsComeOut_data() {
        addColumns<double, double, double, double>("a_um", "length_mm", "flux_w_mm2", "rise_k");
        QTest::newRow("1 µm") << 1.0 << 0.1690 << 196.0 << 416.6;
        QTest::newRow("2 µm") << 2.0 << 0.2390 << 199.9 << 505.2;
        QTest::newRow("5 µm") << 5.0 << 0.3780 << 207.6 << 659.8;
        QTest::newRow("10 µm") << 10.0 << 0.5345 << 216.3 << 817.4;
    }
    void vectorsComeOut() {
        QFETCH(double, a_um);
        QFETCH(double, length_mm);
        QFETCH(double, flux_w_mm2);
        QFETCH(double, rise_k);
        const BurnModel model(hotSteel());
        const Heating heat = model.heating(a_um / 1000);
        QVERIFY(within(heat.length_mm, length_mm, 0.51e-4));
        QVERIFY(within(heat.flux_mw_mm2 / 1000, flux_w_mm2, 0.051));
        QVERIFY(within(model.rise(0, a_um / 1000), rise_k, 0.051));
    }

    void fluxIsThePowerOnTheContact() {
        QVERIFY(holds("q·b·L = P_z·V_k", [] {
            const Project p = anyCutting();
            const double a = decades(-5, -1), Vk = p.machine->wheel_speed_m_s * 1000;
            const Heating heat = BurnModel(p).heating(a);
            RC_ASSERT(close(heat.flux_mw_mm2 * heat.length_mm,
                            forceLaw(p).tangential(1, std::sqrt(a)) * Vk, 1e-14));
            RC_ASSERT(heat.lineForce_n_mm == forceLaw(p).tangential(1, std::sqrt(a)));
        }));
    }

    // The closed form against the heat added up moment by moment.
    void temperatureIsWhatTheFluxAddsUpTo() {
        const Project p = hotSteel();
        const BurnModel model(p);
        for (const double a : {1e-4, 0.002, 0.01, 0.05}) {
            const Heating heat = model.heating(a);
            for (const double h : {0.0, 0.003, 0.02, 0.1, 0.25}) {
                const double expected =
                    riseByMoments(heat.flux_mw_mm2, heat.time_s, 42.7, 10.818, h);
                QVERIFY2(
                    close(model.rise(h, a), expected, 1e-9),
                    qPrintable(
                        QStringLiteral("%1 %2 %3").arg(h).arg(model.rise(h, a)).arg(expected)));
            }
        }
    }

    // Heat that flows ahead and behind is left out: a true band source is never hotter, and the
    // same when it is fast. V_d·L/(4Ω) is Peclet's number.
    void movingBandIsNeverHotterAndTheSameWhenFast() {
        Project p = hotSteel();
        double last = 0;
        for (const double n : {20.0, 180.0, 1000.0, 6000.0, 600e3}) {
            p.machine->work_speed_rpm = n;
            const double Vd = std::numbers::pi * p.part->diameter_mm * n / 60;
            const Heating heat = BurnModel(p).heating(0.02);
            const double band = riseUnderBand(heat.flux_mw_mm2, heat.length_mm, Vd, 42.7, 10.818);
            const double share = band / BurnModel(p).rise(0, 0.02);
            QVERIFY(share > last && share < 1);
            last = share;
        }
        QVERIFY(last > 0.99);
    }

    // MODEL-11: T(0) at the cubic's root equals U_burn; h_d → 0 there; h_d grows with a.
    void surfaceBurnsExactlyBeyondTheCubicsRoot() {
        QVERIFY(holds("cubic", [] {
            const Project p = anyCutting();
            const BurnModel model(p);
            const double U = between(100, 2000);
            const double a = model.burnFreeDepth(U);
            RC_ASSERT(close(model.rise(0, a), U, 1e-12) && model.rise(0, 0) == 0);
            RC_ASSERT(model.damagedDepth(a * (1 - 1e-9), U) == 0);
            const double h = model.damagedDepth(a * (1 + 1e-6), U);
            RC_ASSERT(h > 0);
            // to first order: T falls by the slope scale·erfc(0)/(2√(Ωτ)) from the surface
            RC_ASSERT(h < 1e-6 * 2 * model.heating(a).diffusionDepth_mm);
            RC_ASSERT(model.damagedDepth(a * 1.5, U) > model.damagedDepth(a * 1.4, U));
        }));
    }

    // One term at a time: sharp wheel w³ = U/(c·k_t), frictional heat alone w = U/(c·μk_r).
    void rootOfOneTermIsItsPower() {
        Project p = hotSteel();
        p.wheel->dullness = 0;
        const BurnModel sharp(p);
        QVERIFY(close(sharp.burnFreeDepth(800), sharp.burnFreeDepth(100) * 16, 1e-13)); // 8^(4/3)
        p = hotSteel();
        p.material->shear_strain = 1e-12;
        const BurnModel rubbing(p);
        QVERIFY(close(rubbing.burnFreeDepth(200), rubbing.burnFreeDepth(100) * 16, 1e-9)); // 2⁴
    }

    void damagedLayerEndsWhereTheMetalStaysBelowBurning() {
        QVERIFY(holds("h_d", [] {
            const Project p = anyCutting();
            const BurnModel model(p);
            const double U = between(100, 2000);
            const double a = model.burnFreeDepth(U) * (1 + decades(-6, 3));
            const double h = model.damagedDepth(a, U);
            const double x = h / (2 * model.heating(a).diffusionDepth_mm);
            RC_ASSERT(close(model.rise(h, a), U, 1e-14 * (10 + 4 * x * x)));
        }));
    }

    // The limit inserted gives the limit: T = U at the depth of the stock left, and just this stock
    // is damaged.
    void limitingDepthForTheStockLeftMeetsTheLimit() {
        QVERIFY(holds("limit", [] {
            const Project p = anyCutting();
            const BurnModel model(p);
            const double U = between(100, 2000), stock = decades(-6, 0);
            const double a = model.limitDepth(U, stock);
            RC_ASSERT(close(model.rise(stock, a), U, 1e-12));
            const double reach = 2 * model.heating(a).diffusionDepth_mm;
            RC_ASSERT(within(model.damagedDepth(a, U), stock, 1e-12 * stock + 1e-14 * reach));
            RC_ASSERT(model.limitDepth(U, stock * 1.001) > a);
            RC_ASSERT(a > model.burnFreeDepth(U));
        }));
    }
    void limitingDepthWithNoStockIsTheBurnFreeDepth() {
        const BurnModel model(hotSteel());
        QCOMPARE(model.limitDepth(700, 0.0), model.burnFreeDepth(700));
        QCOMPARE(model.limitDepth(700, -0.01), model.burnFreeDepth(700));
        QVERIFY(close(model.limitDepth(700, 1e-12), model.burnFreeDepth(700), 1e-9));
    }

    void depthsCompareAsTheDamagedLayersDo() {
        QVERIFY(holds("same verdict", [] {
            const BurnModel model(anyCutting());
            const double U = between(100, 2000), stock = fixtures::oneIn(4) ? 0 : decades(-4, -0.5);
            const double limit = model.limitDepth(U, stock);
            const double a = limit * decades(-0.3, 0.3);
            RC_PRE(!close(a, limit, 1e-9));
            RC_ASSERT((a < limit) == (model.damagedDepth(a, U) <= stock));
            RC_ASSERT((a < limit) == (model.rise(stock, a) < U));
        }));
    }

    // --- the table of a run ----------------------------------------------------------------------

    void tableIsTheLimitToAMillionth() {
        QVERIFY(holds("table", [] {
            const BurnModel model(anyCutting());
            const double U = between(200, 1500), deepest = decades(-3, -0.1);
            const BurnTable table(model, U, deepest);
            for (int i = 0; i < 8; ++i) {
                const double stock = between(0, deepest);
                RC_ASSERT(close(table.limit(stock), std::sqrt(model.limitDepth(U, stock)), 1e-6));
            }
            RC_ASSERT(close(table.limit(-1), std::sqrt(model.burnFreeDepth(U)), 1e-12));
            RC_ASSERT(
                close(table.limit(2 * deepest), std::sqrt(model.limitDepth(U, deepest)), 1e-9));
        }));
    }
    void tableSaysWhereItsStepsAreTooWide() {
        Project p = hotSteel();
        QVERIFY(BurnTable(BurnModel(p), 700, 0.2).isResolved());
        int wide = 0;
        for (const double dullness : {0.1, 0.2, 0.4}) {
            for (const double deepest : {0.2, 0.5, 1.0}) {
                p.wheel->dullness = dullness;
                const BurnModel model(p);
                const BurnTable table(model, 700, deepest);
                const bool close = fixtures::close(table.limit(1e-4),
                                                   std::sqrt(model.limitDepth(700, 1e-4)), 1e-6);
                QVERIFY(close || !table.isResolved());
                wide += table.isResolved() ? 0 : 1;
            }
        }
        QVERIFY(wide > 0 && wide < 9);
    }
    void tableOfNoStockIsTheBurnFreeDepth() {
        const BurnModel model(hotSteel());
        const BurnTable table(model, 700, 0);
        QVERIFY(close(table.limit(0.1), std::sqrt(model.burnFreeDepth(700)), 1e-12));
    }

    void polynomialOfAStretchIsTheTableToAMillionth() {
        int found = 0;
        QVERIFY(holds("stretch", [&found] {
            const BurnModel model(anyCutting());
            const double U = between(200, 1500), deepest = decades(-3, -0.1);
            const BurnTable table(model, U, deepest);
            const double low = between(0, 1) * deepest;
            const double high = low + decades(-6, 0) * (deepest - low);
            const auto stretch = table.over(low, high, deepest);
            if (!stretch) {
                return;
            }
            ++found;
            std::vector<double> root, depth;
            double most = 0;
            for (int i = 0; i < 9; ++i) {
                const double stock = between(low, high);
                RC_ASSERT(close(stretch->usage(1, deepest - stock), table.usage(1, stock), 1e-6));
                root.push_back(between(0, 1));
                depth.push_back(deepest - stock);
                most = std::max(most, stretch->usage(root.back(), depth.back()));
            }
            RC_ASSERT(stretch->worst(root.data(), depth.data(), root.size()) == most);
            RC_ASSERT(close(stretch->usage(1, deepest - low / 2), stretch->usage(1, deepest - low),
                            1e-9));
        }));
        QVERIFY2(found > 20, qPrintable(QString::number(found)));
    }
    void narrowStretchesHaveAPolynomialAndTheWholeCurveHasNone() {
        const BurnTable table(BurnModel(hotSteel()), 700, 0.2);
        for (double low = 0; low < 0.2; low += 0.002) {
            QVERIFY(table.over(low, low + 0.002, 0.2));
        }
        QVERIFY(!table.over(0, 0.2, 0.2));
    }
};

} // namespace sparkout::test_burn

SPARKOUT_TEST(test_burn, TestBurn)
#include "test_burn.moc"
