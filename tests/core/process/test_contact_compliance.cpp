// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel's contact in series with the technological system, an option beyond the sources.
#include "core/process/contact_compliance.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <rapidcheck.h>

namespace sparkout::test_contact_compliance {

using fixtures::close;
using fixtures::within;

using Table = std::vector<std::vector<double>>;

const Table rising{{10, 5}, {100, 20}, {400, 60}};
constexpr double bks = 1228, bkr = 2851; // the vectors' page, 40 mm wide

double uniform(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}
double logUniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
}

/// k(F) [N/mm] read off the table.
double stiffness(const Table& table, double F) {
    if (F <= table.front()[0]) {
        return table.front()[1] * 1e3;
    }
    for (std::size_t i = 1; i < table.size(); ++i) {
        if (F <= table[i][0]) {
            const double share = (F - table[i - 1][0]) / (table[i][0] - table[i - 1][0]);
            return (table[i - 1][1] + share * (table[i][1] - table[i - 1][1])) * 1e3;
        }
    }
    return table.back()[1] * 1e3;
}

/// ∫₀^P dF/k(F) by Simpson's rule between the rows.
double quadrature(const Table& table, double P) {
    std::vector<double> joints{0};
    for (const auto& row : table) {
        if (row[0] > 0 && row[0] < P) {
            joints.push_back(row[0]);
        }
    }
    joints.push_back(P);
    double sum = 0;
    for (std::size_t i = 1; i < joints.size(); ++i) {
        constexpr int pieces = 4000;
        const double step = (joints[i] - joints[i - 1]) / pieces;
        for (int k = 0; k < pieces; ++k) {
            const double at = joints[i - 1] + k * step;
            sum += step / 6
                   * (1 / stiffness(table, at) + 4 / stiffness(table, at + step / 2)
                      + 1 / stiffness(table, at + step));
        }
    }
    return sum;
}

/// One lane, cut once at the lag h: its √a.
double rootOf(const ContactCompliance& contact, double gamma, double ks, double kr, double h,
              double last = 0) {
    Lanes lanes(1);
    lanes.share[0] = 1;
    lanes.root[0] = last;
    LaneCoefficients coefficients(1);
    coefficients.set(0, gamma, ks, kr);
    const double root =
        contact.cut(lanes, coefficients, {.base = h}, {.count = 1, .bks = ks, .bkr = kr});
    return root == lanes.root[0] && lanes.depth_mm[0] == root * root ? root : -1;
}

double kernelRoot(double gamma, double ks, double kr, double h) {
    Lanes lanes(1);
    lanes.share[0] = 1;
    LaneCoefficients coefficients(1);
    coefficients.set(0, gamma, ks, kr);
    return widestPassFunction()(lanes, coefficients, {.base = h},
                                {.count = 1, .bks = ks, .bkr = kr});
}

class TestContactCompliance : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(2000); }

    void constantStiffnessIsHookesLaw() {
        const ContactCompliance contact({{50, 10}});
        for (const double P : {0.0, 1e-6, 10.0, 50.0, 51.0, 1e5}) {
            QVERIFY(close(contact.deflection(P), P / 10e3, 1e-15));
            QCOMPARE(contact.compliance(P), 1e-4);
        }
    }

    void deflectionIsTheIntegralOfTheTable_data() {
        addColumns<int, double>("table", "force");
        for (int table = 0; table < 3; ++table) {
            for (const double force : {0.5, 10.0, 37.0, 100.0, 250.0, 400.0, 900.0}) {
                QTest::addRow("table %d, %g N", table, force) << table << force;
            }
        }
    }
    void deflectionIsTheIntegralOfTheTable() {
        QFETCH(int, table);
        QFETCH(double, force);
        const Table tables[] = {rising, {{0, 5}, {100, 5}, {200, 6}}, {{20, 30}, {300, 4}}};
        const ContactCompliance contact(tables[table]);
        QVERIFY(close(contact.deflection(force), quadrature(tables[table], force), 1e-11));
    }

    // dδ_c/dP = 1/k(P), on and between the rows.
    void slopeOfTheDeflectionIsTheCompliance() {
        const ContactCompliance contact(rising);
        for (double P = 1; P < 600; P *= 1.3) {
            const double step = 1e-4 * P;
            const double slope =
                (contact.deflection(P + step) - contact.deflection(P - step)) / (2 * step);
            QVERIFY(close(contact.compliance(P), slope, 1e-4));
            QVERIFY(close(contact.compliance(P), 1 / stiffness(rising, P), 1e-14));
        }
    }

    // A slope of k that is all but none: the logarithm must not lose its digits.
    void almostConstantStiffnessLosesNoDigits() {
        const ContactCompliance contact({{0, 10}, {100, 10 * (1 + 1e-13)}});
        QVERIFY(close(contact.deflection(80), 80 / 10e3, 1e-13));
    }

    // One row: γ + 1/k is the compliance of the two springs in series.
    void constantContactAddsToTheSystemsCompliance() {
        const ContactCompliance contact({{1, 25}});
        for (const double kr : {0.0, bkr, 1e5}) {
            for (const double h : {1e-6, 1e-3, 5e-3, 0.2}) {
                const double u = rootOf(contact, 2e-5, bks, kr, h);
                const double v = kernelRoot(2e-5 + 1 / 25e3, bks, kr, h);
                QVERIFY(within(u * u, v * v, 1e-14));
            }
        }
    }

    void rigidContactIsTheKernel() {
        const ContactCompliance contact({{0, 1e18}, {100, 1e19}});
        for (const double kr : {0.0, bkr, 1e5}) {
            for (const double h : {-1e-3, 0.0, 1e-9, 1e-4, 5e-3, 0.2}) {
                const double u = rootOf(contact, 2e-5, bks, kr, h);
                const double v = kernelRoot(2e-5, bks, kr, h);
                QVERIFY(within(u * u, v * v, 1e-15));
            }
        }
    }

    // a + γ·P + δ_c(P) = h for whatever a table, a system and a lag may be, from any last root: to
    // the roundings of the lag and to that of P, which a contact soft at its end makes δ_c'·P of.
    void balanceHoldsAtEveryRoot() {
        const bool held = rc::check("balance", [] {
            Table table;
            double force = 0;
            for (int i = 0; i < *rc::gen::inRange(1, 8); ++i) {
                force += logUniform(0.1, 1e3);
                table.push_back({force, logUniform(0.1, 1e4)});
            }
            const ContactCompliance contact(table);
            const double gamma = logUniform(1e-9, 1e-2);
            const double ks = logUniform(1, 1e5),
                         kr = *rc::gen::element(0., 1.) * logUniform(1, 1e5);
            const double h = logUniform(1e-9, 3);
            const double u =
                rootOf(contact, gamma, ks, kr, h, *rc::gen::element(0., 1.) * logUniform(1e-6, 2));
            const double P = (ks * u + kr) * u;
            RC_ASSERT(u > 0);
            RC_ASSERT(within(u * u + gamma * P + contact.deflection(P), h,
                             1e-15 + 1e-15 * (h + contact.compliance(P) * P)));
        });
        QVERIFY(held);
    }

    // Where the stiffness falls to a hundredth and rises again at once, Newton's steps alone go to
    // and fro across the turn for good.
    void aStiffnessThatTurnsSharplyIsNoTrap() {
        const ContactCompliance contact(
            {{1.07029, 494.883}, {4.63669, 99.5492}, {172.144, 5.40339}, {188.689, 402.274}});
        constexpr double gamma = 1.1e-5, ks = 3218, kr = 1.2e5;
        for (int i = 0; i <= 1000; ++i) {
            const double h = 0.004 + 6e-6 * i;
            for (const double last : {0.0, 0.0009, 0.0014}) {
                const double u = rootOf(contact, gamma, ks, kr, h, last);
                const double P = (ks * u + kr) * u;
                QVERIFY(within(u * u + gamma * P + contact.deflection(P), h, 1e-15));
            }
        }
    }

    // Range, ramp, sums and depths as the kernel's: the rigid contact over many lanes.
    void passKeepsTheKernelsBooks() {
        const ContactCompliance rigid({{0, 1e18}});
        Lanes one(20), two(20);
        LaneCoefficients coefficients(20);
        for (std::size_t i = 0; i < 20; ++i) {
            coefficients.set(i, 1e-5 * double(1 + i), bks, bkr);
            one.share[i] = two.share[i] = double(i + 1) / 20;
            one.depth_mm[i] = two.depth_mm[i] = 1e-4 * double(i);
        }
        for (int m = 0; m < 30; ++m) {
            const PassFeed feed{0.001 * m, 0.0002, 0.002, 0.001};
            const PassRange range{3, 12, bks, bkr};
            const double largest = rigid.cut(one, coefficients, feed, range);
            QVERIFY(within(largest, widestPassFunction()(two, coefficients, feed, range), 1e-12));
            for (std::size_t i = 0; i < 20; ++i) {
                QVERIFY(within(one.depth_mm[i], two.depth_mm[i], 1e-13));
                QVERIFY(within(one.root[i], two.root[i], 1e-12));
                QVERIFY(within(one.rootSum[i], two.rootSum[i], 1e-11));
            }
        }
        QCOMPARE(one.depth_mm[2], 2e-4); // outside the range
        QCOMPARE(one.root[15], 0.0);
    }
};

} // namespace sparkout::test_contact_compliance

SPARKOUT_TEST(test_contact_compliance, TestContactCompliance)
#include "test_contact_compliance.moc"
