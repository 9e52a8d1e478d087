// SPDX-License-Identifier: GPL-3.0-or-later
// The force by the wheel's recipe: the published sum over the grains, written here once more, is
// the law of the model with the shares that the recipe comes to.

#include "core/process/force.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"
#include "core/surface/cutting.h"
#include "tests/core/support/formula_reader.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <variant>

namespace sparkout::test_recipe_force {

using fixtures::between;
using fixtures::close;

Project anyProject() {
    Project p = fixtures::plunge();
    p.part->diameter_mm = between(10, 200);
    p.wheel->diameter_mm = between(250, 750);
    p.machine->work_speed_rpm = between(50, 400);
    p.wheel->grain_share = between(0.4, 0.6);
    p.wheel->bond_share = between(0.05, 0.2);
    p.wheel->grain_mm = between(0.1, 0.5);
    p.wheel->force_recipe = ForceRecipe{between(0.1, 2), between(0.2, 5), between(15, 60),
                                        between(0.005, 0.1), between(0, 0.08)};
    return p;
}

/// Over the whole range of what can be typed, and a little beyond what is possible.
Project anyRecipe() {
    Project p = anyProject();
    ForceRecipe& recipe = *p.wheel->force_recipe;
    recipe.contact_factor = std::pow(10, between(-1.5, 1.5));
    recipe.cut_width_mm = p.wheel->grain_mm * between(0.5, 1.2);
    recipe.wear_flat_mm = p.wheel->grain_mm * std::pow(10, between(-1, 0.2));
    if (between(0, 1) < 0.4) {
        recipe.cut_width_mm.reset();
    }
    if (between(0, 1) < 0.4) {
        recipe.wear_flat_mm.reset();
    }
    return p;
}

Issues recipeErrors(const Project& p) {
    Issues issues = validate(p);
    std::erase_if(issues, [](const Issue& issue) {
        return issue.severity != Severity::error || !issue.path.starts_with("/wheel/force_recipe/");
    });
    return issues;
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

    /// What no wheel can be, decided here once more from the published n_c: a recipe is refused for
    /// that alone, and its message names an input, what stands there, and a bound at which the
    /// fault is gone.
    void whatNoWheelCanBeIsRefused() {
        int refused = 0, taken = 0;
        QVERIFY(rc::check("impossible", [&] {
            Project p = anyRecipe();
            const ForceRecipe& r = *p.wheel->force_recipe;
            const double Wg = p.wheel->grain_share, Wb = p.wheel->bond_share,
                         dg = p.wheel->grain_mm, lg = r.wear_flat_mm.value_or(0);
            const double nc = Wg * Wb * r.contact_factor / ((1 - Wg - Wb) * dg * dg);
            const double sine = std::sin(r.shear_angle_deg * std::numbers::pi / 180);
            const double bj = r.cut_width_mm.value_or(r.grains_per_mm * sine / (2 * nc));
            const bool counts = r.cut_width_mm || r.wear_flat_mm;
            const bool impossible = counts && (bj > dg || lg > dg || lg * bj * nc > 1);
            const Issues issues = recipeErrors(p);
            RC_ASSERT(issues.empty() != impossible);
            (impossible ? refused : taken)++;
            for (const Issue& issue : issues) {
                const auto& bounds = std::get<Bounds>(issue.limit);
                const auto input = numberInput(p, issue.path);
                RC_ASSERT(input && *input->value == std::get<Amount>(issue.value).number);
                RC_ASSERT(!bounds.range.contains(*input->value));
                Project mended = p;
                const bool low = *input->value < bounds.range.low;
                setNumberInput(mended, issue.path, low ? bounds.range.low : bounds.range.high);
                for (const Issue& left : recipeErrors(mended)) {
                    RC_ASSERT(left.path != issue.path || left.limit != issue.limit);
                }
            }
        }));
        QVERIFY2(refused > 0 && taken > 10, qPrintable(QString("%1/%2").arg(refused).arg(taken)));
    }

    void theMessageNamesInputValueAndBound() {
        Project p = fixtures::plunge(); // W_g 0.5, W_b 0.12, d_g 0.25: n_c = 2.526 k_Y
        p.wheel->force_recipe = ForceRecipe{4, 1, 30, 0.24, 0.2};
        Issues issues = recipeErrors(p);
        QCOMPARE(issues.size(), std::size_t{0}); // η = 0.2·0.24·10.1 = 0.485
        p.wheel->force_recipe->contact_factor = 9;
        issues = recipeErrors(p); // 22.7 grains a mm² of cuts of 0.24 mm: η = 1.09
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].path, std::string("/wheel/force_recipe/wear_flat_mm"));
        QCOMPARE(issueSentence(issues[0]),
                 std::string("0.2 mm is out of range; allowed: 0…0.1832 mm (η = l_g·b_j·n_c ≤ 1)"));
        p.wheel->force_recipe = ForceRecipe{4, 1, 30, 0.26, {}};
        issues = recipeErrors(p);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].path, std::string("/wheel/force_recipe/cut_width_mm"));
        QCOMPARE(issueSentence(issues[0]), std::string("0.26 mm is out of range; allowed: "
                                                       "0…0.25 mm (/wheel/grain_mm)"));
    }

    /// A wheel may become all flats, as one that dulls does in the end, and no further.
    void theDullestWheelIsTaken() {
        QVERIFY(rc::check("η = 1", [] {
            Project p = anyProject();
            ForceRecipe& recipe = *p.wheel->force_recipe;
            recipe.cut_width_mm = p.wheel->grain_mm * between(0.2, 1);
            const RecipeShares shares = recipeShares(*p.wheel, recipe);
            recipe.contact_factor /= // so that flats as long as a grain or shorter are enough
                shares.cuttingGrains_mm2 * shares.cutWidth_mm * p.wheel->grain_mm / between(1.1, 3);
            setDullness(*p.wheel, 1);
            RC_ASSERT(recipeErrors(p).empty());
            *recipe.wear_flat_mm *= 1.001;
            RC_ASSERT(recipeErrors(p).size() == 1);
        }));
    }

    /// Chips that are many times the metal taken off, or more grains than find room, are possible
    /// as far as the theory goes: a warning.
    void whatIsHardlyPossibleIsWarnedOf() {
        const auto warned = [](const ForceRecipe& recipe, const std::string& key) {
            Project p = fixtures::plunge();
            p.wheel->force_recipe = recipe;
            return std::ranges::any_of(validate(p), [&key](const Issue& issue) {
                return issue.path == "/wheel/force_recipe/" + key
                       && issue.severity == Severity::warning;
            });
        };
        QVERIFY(!warned({1, 1, 30, 0.1, {}}, "cut_width_mm"));   // κ = 1.01
        QVERIFY(warned({10, 1, 30, 0.1, {}}, "cut_width_mm"));   // κ = 10.1
        QVERIFY(warned({1, 10, 30, 0.05, {}}, "cut_width_mm"));  // κ = 0.05
        QVERIFY(!warned({7, 5, 30, 0.1, {}}, "contact_factor")); // 17.7 a mm² of 18.5
        QVERIFY(warned({8, 5, 30, 0.1, {}}, "contact_factor"));
        QVERIFY(!warned({1, 1, 30, 0.1, 0.08}, "wear_flat_mm")); // η = 0.02
        QVERIFY(!warned({1, 1, 30, 0.1, 0.2}, "wear_flat_mm"));  // η = 0.05
        QVERIFY(warned({2, 1, 30, 0.2, 0.25}, "wear_flat_mm"));  // η = 0.253
    }
};

} // namespace sparkout::test_recipe_force

SPARKOUT_TEST(test_recipe_force, TestRecipeForce)
#include "test_recipe_force.moc"
