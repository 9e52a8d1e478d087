// SPDX-License-Identifier: GPL-3.0-or-later
// The force by the wheel's recipe: the published sum over the grains, written here once more, is
// the law of the model with the shares that the recipe comes to.
#include "core/process/recipe_force.h"

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>

namespace test_recipe_force {

using namespace sparkout;
using fixtures::between;
using fixtures::close;

namespace {

Project anyProject() {
    Project p = fixtures::plunge();
    p.part->diameter_mm = between(10, 200);
    p.wheel->diameter_mm = between(250, 750);
    p.machine->work_speed_rpm = between(50, 400);
    p.wheel->grain_share = between(0.4, 0.6);
    p.wheel->bond_share = between(0.05, 0.2);
    p.wheel->grain_mm = between(0.1, 0.5);
    return p;
}

ForceRecipe anyRecipe() {
    return {between(0.1, 2), between(0.2, 5), between(0.005, 0.1), between(0, 0.1),
            between(15, 60)};
}

/// Eq. 7 as it is printed, with the lengths in mm and the speeds in one unit.
double published(const Project& p, const ForceRecipe& r, double B, double a) {
    const double d = p.part->diameter_mm, D = p.wheel->diameter_mm;
    const double Vd = std::numbers::pi * d * p.machine->work_speed_rpm; // mm/min
    const double Vk = p.machine->wheel_speed_m_s * 1000 * 60;           // mm/min
    const double sigma = p.material->flow_stress_mpa, tgBeta = 1.9 / 2.8;
    const double Wg = p.wheel->grain_share, Wb = p.wheel->bond_share, dg = p.wheel->grain_mm;
    const double L = std::sqrt(a * d * D / (d + D));
    const double N = Wg * Wb * r.contactFactor * B * L / ((1 - Wg - Wb) * dg * dg);
    const double ak = 2 * Vd * std::sqrt(a) / (Vk * r.grainsPerMm) * std::sqrt((D + d) / (D * d));
    const double sine = std::sin(r.shearAngle_deg * std::numbers::pi / 180);
    return 2.8 * ak * sigma / sine * tgBeta * r.cutWidth_mm * N
           + sigma / 3 * r.flatLength_mm * r.cutWidth_mm * N;
}

} // namespace

class TestRecipeForce : public QObject {
    Q_OBJECT

private slots:
    void thePublishedSumIsTheLaw() {
        QVERIFY(rc::check("eq. 7", [] {
            const Project p = anyProject();
            const ForceRecipe r = anyRecipe();
            const double B = between(1, 60), a = between(1e-5, 0.05);
            RC_ASSERT(
                close(forceLawOf(p, r).normal(B, std::sqrt(a)), published(p, r, B, a), 1e-12));
        }));
    }

    /// With chips that are together the metal taken off it is that of the model.
    void balancedChipsGiveTheModelsLaw() {
        QVERIFY(rc::check("κ = 1", [] {
            Project p = anyProject();
            ForceRecipe r = anyRecipe();
            r.cutWidth_mm = balancedCutWidth(p, r);
            const RecipeShares shares = recipeShares(p, r);
            RC_ASSERT(close(shares.shear, 1, 1e-12));
            p.wheel->dullness = shares.dullness;
            const ForceLaw model = forceLaw(p), recipe = forceLawOf(p, r);
            RC_ASSERT(close(model.ks, recipe.ks, 1e-12) && close(model.kt, recipe.kt, 1e-12));
            RC_ASSERT(model.kr == recipe.kr && model.mu == recipe.mu);
        }));
    }

    void sharpGrainsHaveNoFrictionAndMoreGrainsMoreForce() {
        Project p = fixtures::plunge();
        ForceRecipe r{1, 1, 0.02, 0, 30};
        QCOMPARE(forceLawOf(p, r).kr, 0.0);
        r.flatLength_mm = 0.02;
        const double before = forceLawOf(p, r).normal(40, 0.05);
        p.wheel->grain_share += 0.05; // a closer structure
        QVERIFY(forceLawOf(p, r).normal(40, 0.05) > before);
        p.wheel->grain_mm *= 2; // a coarser grain
        QVERIFY(forceLawOf(p, r).normal(40, 0.05) < before);
    }
};

} // namespace test_recipe_force

SPARKOUT_TEST(test_recipe_force, TestRecipeForce)
#include "test_recipe_force.moc"
