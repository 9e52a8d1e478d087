// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/profile.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_profile {

using fixtures::within;

// A radius is some tens of mm and comes out of some ten operations.
constexpr double radiusRounding = 10 * 64 * fixtures::epsilon;

Part part(ProfileForm form, Surface surface = Surface::external) {
    Part p;
    p.surface = surface;
    p.profile = form;
    p.diameter_mm = 40;
    p.upper_deviation_um = 5;
    p.lower_deviation_um = -15;
    p.stock_mm = 0.2;
    p.initial_runout_mm = 0.06;
    p.radii_per_section = 36;
    if (form == ProfileForm::measured) {
        p.radii_um.emplace();
        for (int k = 0; k < 36; ++k) {
            p.radii_um->push_back(-20 + 7 * std::sin(k) - k % 5);
        }
    }
    return p;
}

double runout(const std::vector<double>& radii) {
    const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
    return *high - *low;
}

class TestProfile : public QObject {
    Q_OBJECT

private slots:
    // MODEL-4: R_t = d/2 + (upper + lower)/4
    void targetIsTheMiddleOfTheFieldUnlessGiven() {
        Part p = part(ProfileForm::ellipse);
        QVERIFY(within(targetRadius(p), 19.9975, radiusRounding));
        p.target_diameter_mm = 40.003;
        QCOMPARE(targetRadius(p), 40.003 / 2);
    }

    void firstTouchStandsStockAndRunoutFromTheTarget_data() { everyForm(); }
    void firstTouchStandsStockAndRunoutFromTheTarget() {
        QFETCH(ProfileForm, form);
        QFETCH(Surface, surface);
        const Part p = part(form, surface);
        const Blank blank = makeBlank(p);
        const double dR = form == ProfileForm::measured ? runout(*p.radii_um) / 1000 : 0.06;
        const double side = surface == Surface::external ? 1 : -1;
        QVERIFY(within(blank.totalInfeed_mm, 0.2 + dR, 4 * fixtures::epsilon));
        QVERIFY(within(blank.firstTouchRadius_mm, blank.targetRadius_mm + side * (0.2 + dR),
                       radiusRounding));
        QVERIFY(within(initialRunout(p), dR, 4 * fixtures::epsilon));
    }

    // The wheel touches the outstanding radius at t_П = 0, and every form's span is ΔR.
    void depthsRunFromFirstTouchToTheRunout_data() { everyForm(); }
    void depthsRunFromFirstTouchToTheRunout() {
        QFETCH(ProfileForm, form);
        QFETCH(Surface, surface);
        const Part p = part(form, surface);
        const Blank blank = makeBlank(p);
        const auto [low, high] = std::minmax_element(blank.depth_mm.begin(), blank.depth_mm.end());
        QCOMPARE(blank.depth_mm.size(), std::size_t(36));
        QVERIFY(*low >= 0);
        QVERIFY(within(*low, 0, radiusRounding));
        QVERIFY(within(*high, initialRunout(p), radiusRounding));
    }

    // A shaft's depth and a bore's add up to ΔR: what stands out in one lies deep in the other.
    void boreIsTheShaftSeenFromTheOtherSide_data() { everyForm(); }
    void boreIsTheShaftSeenFromTheOtherSide() {
        QFETCH(ProfileForm, form);
        const Blank shaft = makeBlank(part(form, Surface::external));
        const Blank bore = makeBlank(part(form, Surface::internal));
        const double dR = initialRunout(part(form));
        for (std::size_t k = 0; k < 36; ++k) {
            // Lobes and measured deviations are the same curve. Ellipse and eccentric circle differ
            // from ΔR·sin²φ by terms of ΔR²/R, and R differs by 2Π + ΔR = 0.46 between the two.
            const bool same = form == ProfileForm::lobes || form == ProfileForm::measured;
            const double shape = same ? 0 : dR * dR / 20 * (0.46 / 20);
            QVERIFY(within(shaft.depth_mm[k] + bore.depth_mm[k], dR, shape + radiusRounding));
        }
    }

    // MODEL-4: polar ellipse with semi-axes p = R_max, q = R_max − ΔR: x²/p² + y²/q² = 1.
    void ellipseSatisfiesItsEquation() {
        const Part p = part(ProfileForm::ellipse);
        const std::vector<double> R = profileRadii(p, 20.3);
        QCOMPARE(R.size(), std::size_t(36));
        for (int k = 0; k < 36; ++k) {
            const double phi = 2 * std::numbers::pi * k / 36;
            const double x = R[std::size_t(k)] * std::cos(phi) / 20.3;
            const double y = R[std::size_t(k)] * std::sin(phi) / 20.24;
            QVERIFY(within(x * x + y * y, 1, 10 * fixtures::epsilon));
        }
        QVERIFY(within(R[0], 20.3, radiusRounding));
        QVERIFY(within(R[9], 20.24, radiusRounding));
    }

    // All points of an eccentric circle lie R_max − ΔR/2 from a centre ΔR/2 off the axis.
    void eccentricCircleIsACircleAboutItsOwnCentre() {
        const std::vector<double> R = profileRadii(part(ProfileForm::eccentric), 20.3);
        for (int k = 0; k < 36; ++k) {
            const double phi = 2 * std::numbers::pi * k / 36;
            const double x = R[std::size_t(k)] * std::cos(phi) - 0.03;
            const double y = R[std::size_t(k)] * std::sin(phi);
            QVERIFY(within(std::hypot(x, y), 20.27, radiusRounding));
        }
        QVERIFY(within(R[0] - R[18], 0.06, radiusRounding));
    }

    void lobedFormHasItsNumberOfLobes_data() {
        QTest::addColumn<int>("lobes");
        for (const int lobes : {2, 3, 4, 6, 9}) { // divisors of 36: a summit falls on a radius
            QTest::addRow("%d", lobes) << lobes;
        }
    }
    void lobedFormHasItsNumberOfLobes() {
        QFETCH(int, lobes);
        Part p = part(ProfileForm::lobes);
        p.lobes = lobes;
        const std::vector<double> R = profileRadii(p, 20.3);
        int summits = 0;
        for (std::size_t k = 0; k < 36; ++k) {
            summits += R[k] > R[(k + 35) % 36] && R[k] > R[(k + 1) % 36];
            QVERIFY(within(R[k], R[(k + 36 / std::size_t(lobes)) % 36], radiusRounding));
        }
        QCOMPARE(summits, lobes);
        QVERIFY(within(R[0], 20.3, radiusRounding));
    }

    // Deviations count from the largest radius, wherever their zero stands.
    void measuredProfileKeepsItsDifferencesAndIgnoresItsOffset() {
        Part p = part(ProfileForm::measured);
        const std::vector<double> R = profileRadii(p, 20.3);
        for (double& um : *p.radii_um) {
            um += 13.5;
        }
        const std::vector<double> shifted = profileRadii(p, 20.3);
        for (std::size_t k = 0; k < 36; ++k) {
            QVERIFY(
                within(R[k] - R[0], ((*p.radii_um)[k] - (*p.radii_um)[0]) / 1000, radiusRounding));
            QVERIFY(within(R[k], shifted[k], radiusRounding));
        }
        QVERIFY(within(*std::max_element(R.begin(), R.end()), 20.3, radiusRounding));
    }

    void measuredRunoutReplacesTheGivenOne() {
        Part p = part(ProfileForm::measured);
        const double measured = initialRunout(p);
        p.initial_runout_mm = 1;
        QCOMPARE(initialRunout(p), measured);
        QVERIFY(within(measured, runout(*p.radii_um) / 1000, fixtures::epsilon));
    }

    void roundBlankIsTouchedEverywhereAtOnce() {
        for (const ProfileForm form :
             {ProfileForm::ellipse, ProfileForm::eccentric, ProfileForm::lobes}) {
            for (const Surface surface : {Surface::external, Surface::internal}) {
                Part p = part(form, surface);
                p.initial_runout_mm = 0;
                for (const double depth : makeBlank(p).depth_mm) {
                    QVERIFY(depth >= 0 && depth <= radiusRounding);
                }
            }
        }
    }

private:
    static void everyForm() {
        addColumns<ProfileForm, Surface>("form", "surface");
        const std::pair<const char*, ProfileForm> forms[] = {{"ellipse", ProfileForm::ellipse},
                                                             {"eccentric", ProfileForm::eccentric},
                                                             {"lobes", ProfileForm::lobes},
                                                             {"measured", ProfileForm::measured}};
        for (const auto& [name, form] : forms) {
            QTest::addRow("%s, shaft", name) << form << Surface::external;
            QTest::addRow("%s, bore", name) << form << Surface::internal;
        }
    }
};

} // namespace sparkout::test_profile

SPARKOUT_TEST(test_profile, TestProfile)
#include "test_profile.moc"
