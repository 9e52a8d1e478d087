// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/force.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_force {

using fixtures::close;
using fixtures::within;

// Ten roundings at most stand between the inputs and a coefficient.
constexpr double roundings = 10 * fixtures::epsilon;

Project bore() {
    Project project = fixtures::plunge();
    project.part->surface = Surface::internal;
    project.wheel->diameter_mm = 20;
    return project;
}

class TestForce : public QObject {
    Q_OBJECT

private slots:
    // shared/vectors: k_s·B = 1227.913929 N/mm, k_r·B = 2850.786580 N/√mm
    void fullLawCaseGivesThePublishedCoefficients() {
        const ForceLaw law = forceLaw(fixtures::plunge());
        QVERIFY(within(law.ks * 40, 1227.913929, 0.5e-6));
        QVERIFY(within(law.kr * 40, 2850.786580, 0.5e-6));
    }

    // The sources' K1…K4 (MODEL-9: products, V_k in mm/min), for both widths of cut.
    void coefficientsOfTheSourcesAreTheLawTimesTheWidth_data() {
        QTest::addColumn<bool>("internal");
        QTest::newRow("external") << false;
        QTest::newRow("internal") << true;
    }
    void coefficientsOfTheSourcesAreTheLawTimesTheWidth() {
        QFETCH(bool, internal);
        const Project p = internal ? bore() : fixtures::plunge();
        const double sigma = 2000, eta = 0.02, d = 30, n = 180, B = 40, pi = std::numbers::pi;
        const double Vk = 35 * 60 * 1000, Sax = 1800;
        const double D = p.wheel->diameter_mm;
        const double De = internal ? D * d / (d - D) : D * d / (D + d);
        const double K1 = 1.9 * sigma * pi * d * Sax / Vk;
        const double K2 = eta * (Sax / n) * sigma / 3 * std::sqrt(De);
        const double K3 = 1.9 * sigma * pi * d * n * B / Vk;
        const double K4 = eta * B * sigma / 3 * std::sqrt(De);
        const ForceLaw law = forceLaw(p);
        for (const double a : {1e-9, 1e-4, 0.005, 0.05}) {
            const double u = std::sqrt(a);
            QVERIFY(close(law.normal(Sax / n, u), K1 * a + K2 * u, roundings));
            QVERIFY(close(law.normal(B, u), K3 * a + K4 * u, roundings));
        }
    }

    // MODEL-2: P_z = b·(ε_i·σ_i·V_d/V_k·a + μ·η·σ_i·√(D_e·a)/3)
    void tangentialForceIsShearAndFrictionOfItsOwn() {
        Project p = fixtures::plunge();
        p.material->friction = 0.4;
        const double a = 0.005, b = 40, De = 30.0 * 600 / 630;
        const double expected = b
                                * (2.8 * 2000 * std::numbers::pi * 30 * 180 / (35 * 60e3) * a
                                   + 0.4 * 0.02 * 2000 * std::sqrt(De * a) / 3);
        QVERIFY(close(forceLaw(p).tangential(b, std::sqrt(a)), expected, roundings));
    }

    void sharpWheelHasNoFriction() {
        Project p = fixtures::plunge();
        p.wheel->dullness = 0;
        const ForceLaw law = forceLaw(p);
        QCOMPARE(law.kr, 0.0);
        QVERIFY(close(law.normal(40, std::sqrt(0.01)), 2 * law.normal(40, std::sqrt(0.005)),
                      roundings));
    }

    // One term at a time: doubling an input changes exactly the terms that hold it, by a power of
    // two and so to the last bit.
    void eachInputActsOnItsOwnTerm() {
        struct Case {
            const char* name;
            double& (*input)(Project&);
            double ks, kr, kt, mu; ///< factors when the input doubles
        };
        const Case cases[] = {
            {"flow stress", [](Project& p) -> double& { return p.material->flow_stress_mpa; }, 2, 2,
             2, 1},
            {"dullness", [](Project& p) -> double& { return p.wheel->dullness; }, 1, 2, 1, 1},
            {"work speed", [](Project& p) -> double& { return p.machine->work_speed_rpm; }, 2, 1, 2,
             1},
            {"wheel speed", [](Project& p) -> double& { return p.machine->wheel_speed_m_s; }, 0.5,
             1, 0.5, 1},
            {"shear factor", [](Project& p) -> double& { return p.material->shear_factor; }, 2, 1,
             1, 1},
            {"shear strain", [](Project& p) -> double& { return p.material->shear_strain; }, 1, 1,
             2, 1},
            {"friction", [](Project& p) -> double& { return p.material->friction; }, 1, 1, 1, 2},
            {"wheel width", [](Project& p) -> double& { return p.wheel->width_mm; }, 1, 1, 1, 1}};
        const ForceLaw law = forceLaw(fixtures::plunge());
        for (const Case& c : cases) {
            Project p = fixtures::plunge();
            c.input(p) *= 2;
            const ForceLaw changed = forceLaw(p);
            QVERIFY2(changed.ks == c.ks * law.ks && changed.kr == c.kr * law.kr
                         && changed.kt == c.kt * law.kt && changed.mu == c.mu * law.mu,
                     c.name);
        }
    }

    // d − D_e = d·D_e/D external: a wheel without end leaves d itself. Internal: D_e > D, and the
    // curvatures 1/D ∓ 1/d add up to 1/D_e.
    void endlessWheelMakesTheEquivalentDiameterTheShafts() {
        const double d = 30;
        for (double D = 100; D <= 1e9; D *= 10) {
            const double De = equivalentDiameter(d, D, Surface::external);
            QVERIFY(De < d);
            QVERIFY(within(d - De, d * De / D, 4 * fixtures::epsilon * d));
        }
        QVERIFY(within(equivalentDiameter(d, 1e18, Surface::external), d, 4e-15));
    }

    void curvaturesAddUpToTheEquivalentDiameters() {
        for (const double D : {5.0, 12.5, 29.0, 29.99}) {
            const double inside = equivalentDiameter(30, D, Surface::internal);
            const double outside = equivalentDiameter(30, D, Surface::external);
            QVERIFY(inside > D && outside < D);
            QVERIFY(close(1 / inside, 1 / D - 1.0 / 30, 1e-12)); // D near d: the difference cancels
            QVERIFY(close(1 / outside, 1 / D + 1.0 / 30, roundings));
        }
    }
};

} // namespace sparkout::test_force

SPARKOUT_TEST(test_force, TestForce)
#include "test_force.moc"
