// SPDX-License-Identifier: GPL-3.0-or-later
// The force by the wheel's recipe: the published sum over the grains, written here once more, is
// the law of the model with the shares that the recipe comes to.
#include "core/process/recipe_force.h"

#include "core/format/project_file.h"
#include "core/limits/cutting.h"
#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/number_input.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/formula_reader.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

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
    p.wheel->force_recipe = ForceRecipe{between(0.1, 2), between(0.2, 5), between(15, 60),
                                        between(0.005, 0.1), between(0, 0.1)};
    return p;
}

/// Eq. 7 as it is printed, with the lengths in mm and the speeds in one unit.
double published(const Project& p, double B, double a) {
    const ForceRecipe& r = *p.wheel->force_recipe;
    const double d = p.part->diameter_mm, D = p.wheel->diameter_mm;
    const double Vd = std::numbers::pi * d * p.machine->work_speed_rpm; // mm/min
    const double Vk = p.machine->wheel_speed_m_s * 1000 * 60;           // mm/min
    const double sigma = p.material->flow_stress_mpa, tgBeta = 1.9 / 2.8;
    const double Wg = p.wheel->grain_share, Wb = p.wheel->bond_share, dg = p.wheel->grain_mm;
    const double L = std::sqrt(a * d * D / (d + D));
    const double N = Wg * Wb * r.contact_factor * B * L / ((1 - Wg - Wb) * dg * dg);
    const double ak = 2 * Vd * std::sqrt(a) / (Vk * r.grains_per_mm) * std::sqrt((D + d) / (D * d));
    const double sine = std::sin(r.shear_angle_deg * std::numbers::pi / 180);
    return 2.8 * ak * sigma / sine * tgBeta * *r.cut_width_mm * N
           + sigma / 3 * *r.wear_flat_mm * *r.cut_width_mm * N;
}

bool same(const ForceLaw& a, const ForceLaw& b) {
    return a.ks == b.ks && a.kr == b.kr && a.kt == b.kt && a.mu == b.mu;
}

} // namespace

class TestRecipeForce : public QObject {
    Q_OBJECT

private slots:
    void thePublishedSumIsTheLaw() {
        QVERIFY(rc::check("eq. 7", [] {
            const Project p = anyProject();
            const double B = between(1, 60), a = between(1e-5, 0.05);
            RC_ASSERT(close(forceLaw(p).normal(B, std::sqrt(a)), published(p, B, a), 1e-12));
        }));
    }

    /// A recipe that states neither the grains' cuts nor their flats is the law of section 2.
    void withoutCutsAndFlatsItIsTheLawToTheBit() {
        QVERIFY(rc::check("reduces", [] {
            Project p = anyProject();
            p.wheel->force_recipe->cut_width_mm.reset();
            p.wheel->force_recipe->wear_flat_mm.reset();
            Project plain = p;
            plain.wheel->force_recipe.reset();
            RC_ASSERT(same(forceLaw(p), forceLaw(plain)));
        }));
    }

    /// With chips that are together the metal taken off it is that of the model, η being that of
    /// the flats.
    void balancedChipsGiveTheModelsLaw() {
        QVERIFY(rc::check("κ = 1", [] {
            Project p = anyProject();
            ForceRecipe& recipe = *p.wheel->force_recipe;
            recipe.cut_width_mm.reset();
            const RecipeShares shares = recipeShares(*p.wheel, recipe);
            recipe.cut_width_mm = shares.cutWidth_mm;
            RC_ASSERT(close(recipeShares(*p.wheel, recipe).shear, 1, 1e-12));
            Project plain = p;
            plain.wheel->force_recipe.reset();
            plain.wheel->dullness = shares.dullness;
            const ForceLaw model = forceLaw(plain), law = forceLaw(p);
            RC_ASSERT(close(model.ks, law.ks, 1e-12) && close(model.kt, law.kt, 1e-12));
            RC_ASSERT(close(model.kr, law.kr, 1e-12) && model.mu == law.mu);
        }));
    }

    void sharpGrainsHaveNoFrictionAndMoreGrainsMoreForce() {
        Project p = fixtures::plunge();
        p.wheel->force_recipe = ForceRecipe{1, 1, 30, 0.02, 0.0};
        QCOMPARE(forceLaw(p).kr, 0.0);
        p.wheel->force_recipe->wear_flat_mm = 0.02;
        const double before = forceLaw(p).normal(40, 0.05);
        p.wheel->grain_share += 0.05; // a closer structure
        QVERIFY(forceLaw(p).normal(40, 0.05) > before);
        p.wheel->grain_mm *= 2; // a coarser grain
        QVERIFY(forceLaw(p).normal(40, 0.05) < before);
    }

    /// Batch, wear and identification give a wheel its dullness: by the flats, where they count.
    void dullnessIsSetByTheInputThatCounts() {
        QVERIFY(rc::check("η", [] {
            Project p = anyProject();
            const double eta = between(0.005, 0.2), before = p.wheel->dullness;
            setDullness(*p.wheel, eta);
            RC_ASSERT(close(dullnessOf(*p.wheel), eta, 1e-12) && p.wheel->dullness == before);
            RC_ASSERT(numberInput(p, dullnessPath(*p.wheel)).has_value());
            RC_ASSERT(!numberInput(p, "/wheel/dullness").has_value());
            p.wheel->force_recipe->wear_flat_mm.reset();
            setDullness(*p.wheel, eta);
            RC_ASSERT(p.wheel->dullness == eta && dullnessOf(*p.wheel) == eta);
            RC_ASSERT(numberInput(p, dullnessPath(*p.wheel))->value == eta);
        }));
    }

    /// A cycle of the engine by the recipe is that of the wheel with what it comes to.
    void aCycleRunsByTheRecipe() {
        Project p = fixtures::plunge();
        p.wheel->force_recipe.emplace().wear_flat_mm = 0.05;
        Project plain = p;
        plain.wheel->dullness = dullnessOf(*p.wheel);
        plain.wheel->force_recipe.reset();
        const SimulationResult byRecipe = simulate(p), byLaw = simulate(plain);
        QVERIFY(plain.wheel->dullness != p.wheel->dullness);
        QCOMPARE(byRecipe.status, RunStatus::completed);
        QCOMPARE(byRecipe.time_s, byLaw.time_s);
    }

    /// Every equation of the sheets, read back and worked out from its own numbers.
    void itsFormulasHold() {
        QVERIFY(rc::check("sheets", [] {
            Project p = anyProject();
            if (between(0, 1) < 0.5) {
                p.wheel->force_recipe->cut_width_mm.reset();
            }
            if (between(0, 1) < 0.5) {
                p.wheel->force_recipe->wear_flat_mm.reset();
            }
            const double b = between(1, 60), a = between(1e-4, 0.05);
            for (const FormulaSheet& sheet :
                 {normalForceSheet(p, b, a), tangentialForceSheet(p, b, a)}) {
                for (const FormulaStep& step : sheet.steps) {
                    const fixtures::Quantity said = fixtures::workOut(step);
                    RC_ASSERT(std::abs(said.value - step.result.value) <= 4 * said.uncertainty);
                }
            }
        }));
    }

    void aFileKeepsIt() {
        QVERIFY(rc::check("file", [] {
            const Project p = anyProject();
            const ReadResult read = readProject(writeProject(p));
            RC_ASSERT(read.project.has_value());
            RC_ASSERT(read.project->wheel->force_recipe.has_value());
            RC_ASSERT(same(forceLaw(*read.project), forceLaw(p)));
        }));
        QVERIFY(writeProject(fixtures::plunge()).find("force_recipe") == std::string::npos);
    }

    /// Grain and bond leave pores; without a recipe nothing rests on them here.
    void aSolidWheelIsRefused() {
        Project p = fixtures::plunge();
        p.wheel->grain_share = 0.6;
        p.wheel->bond_share = 0.4;
        const auto isRefused = [&p] {
            return std::ranges::any_of(validate(p), [](const Issue& issue) {
                return issue.path == "/wheel/bond_share" && issue.severity == Severity::error;
            });
        };
        QVERIFY(!isRefused());
        p.wheel->force_recipe.emplace();
        QVERIFY(isRefused());
    }
};

} // namespace test_recipe_force

SPARKOUT_TEST(test_recipe_force, TestRecipeForce)
#include "test_recipe_force.moc"
