// SPDX-License-Identifier: GPL-3.0-or-later
// What a requirement says of itself, and the depths of cut that the requirements allow.
#include "core/quality/constraints.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/limit_series.h"

#include "tests/core/support/demanding_project.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <map>

namespace sparkout::test_constraint_sheet {

using fixtures::close;
using fixtures::plungeStage;
using fixtures::Traced;

Project asking(const Project& of) {
    Project p = fixtures::demanding(of);
    p.machine->geometric_runout_um = 1;
    p.wheel->grain_surface_energy_j_m2 = 18000;
    p.wheel->bond_surface_energy_j_m2 = 4000;
    return p;
}

Project plunge() {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 12;
    p.part->initial_runout_mm = 0.03;
    p.sections = 2;
    p.machine->compliance_mm_per_n = std::vector<double>{4e-5, 7e-5};
    return asking(p);
}

void bothOperations() {
    QTest::addColumn<Project>("project");
    QTest::newRow("traverse") << asking(fixtures::traverse());
    QTest::newRow("plunge") << plunge();
}

class TestConstraintSheet : public QObject {
    Q_OBJECT

private slots:
    void sheetEndsWithTheNumberOfTheVerdict_data() { bothOperations(); }
    void sheetEndsWithTheNumberOfTheVerdict() {
        QFETCH(Project, project);
        const SimulationResult result = simulateUnchecked(project);
        const PartAccuracy accuracy = accuracyOf(result);
        const std::map<std::string, double> toUnit{{"mm", 1000}, {"mW", 1e-6}};
        int stated = 0;
        for (const ConstraintResult& c : evaluateConstraints(result, accuracy)) {
            const auto sheet = constraintSheet(result, accuracy, c);
            const bool readOff = c.kind == ConstraintKind::diameterMin
                                 || c.kind == ConstraintKind::diameterMax
                                 || requirementOf(c.kind).scope == ConstraintScope::setting;
            QCOMPARE(sheet.has_value(), !readOff);
            if (!sheet) {
                continue;
            }
            ++stated;
            QVERIFY(*sheet->name && *sheet->source);
            const FormulaTerm& last = sheet->result();
            QVERIFY2(toUnit.count(last.unit), last.unit);
            const double shown = last.value * toUnit.at(last.unit);
            if (c.kind == ConstraintKind::burn) {
                QVERIFY(close(shown, c.limit, 1e-12));
            } else if (c.kind != ConstraintKind::selfSharpening) {
                QVERIFY2(close(shown, c.value, 1e-9), requirementOf(c.kind).key);
            }
        }
        QVERIFY(stated >= 10);
    }

    // A depth at its limit meets the requirement with nothing to spare: cut that deep, and a
    // hair deeper, and the verdict turns.
    void depthLimitIsWhereTheVerdictTurns_data() { bothOperations(); }
    void depthLimitIsWhereTheVerdictTurns() {
        QFETCH(Project, project);
        const Traced run(project);
        const auto all = evaluateConstraints(run.result);
        for (const ConstraintKind kind :
             {ConstraintKind::burn, ConstraintKind::selfSharpening, ConstraintKind::wheelPower,
              ConstraintKind::workPower, ConstraintKind::roughness}) {
            bool within = true;
            for (const Pass& pass : run.trajectory.passes) {
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    const Visit& visit = run.visit(pass, k);
                    const double stock =
                        std::max(0.0, visit.radius_mm - makeBlank(*project.part).targetRadius_mm);
                    const auto limits = depthLimits(project, pass.effectiveWidth_mm, stock);
                    QCOMPARE(limits.size(), std::size_t(5));
                    const auto limit = std::ranges::find(limits, kind, &DepthLimit::kind);
                    within = within && visit.actual_mm <= limit->depth_mm;
                }
            }
            if (kind != ConstraintKind::roughness) { // which looks at the last cuts alone
                const auto found = std::ranges::find(all, kind, &ConstraintResult::kind);
                QCOMPARE(found->holds, within);
            }
        }
    }

    void widthOfAPlaceIsThatOfItsPass_data() { bothOperations(); }
    void widthOfAPlaceIsThatOfItsPass() {
        QFETCH(Project, project);
        const Traced run(project);
        for (const Pass& pass : run.trajectory.passes) {
            QCOMPARE(effectiveWidth(project, pass.place), pass.effectiveWidth_mm);
        }
    }

    void nothingAskedLimitsNothing() { QVERIFY(depthLimits(fixtures::plunge(), 40, 0.1).empty()); }

    void limitsOfRoughnessAndPowerBringTheirNumbersBack() {
        Project p = plunge();
        const auto limits = depthLimits(p, 40, 0);
        const auto depthOf = [&](ConstraintKind kind) {
            return std::ranges::find(limits, kind, &DepthLimit::kind)->depth_mm;
        };
        SimulationResult result = simulateUnchecked(p);
        for (SectionResult& section : result.sections) {
            section.lastCut->depth_mm = depthOf(ConstraintKind::roughness);
            section.lastCut->sparkOut_s = 0;
        }
        for (const ConstraintResult& c : evaluateConstraints(result)) {
            if (c.kind == ConstraintKind::roughness) {
                QVERIFY(close(c.value, c.limit, 1e-9));
            }
        }
        QVERIFY(depthOf(ConstraintKind::burn) > 0);
        p.wheel->dullness = 1; // too dull for these grains at any depth
        p.wheel->grain_surface_energy_j_m2 = 1e-3;
        const auto dull = depthLimits(p, 40, 0);
        QCOMPARE(
            std::ranges::find(dull, ConstraintKind::selfSharpening, &DepthLimit::kind)->depth_mm,
            0.0);
    }
};

} // namespace sparkout::test_constraint_sheet

SPARKOUT_TEST(test_constraint_sheet, TestConstraintSheet)
#include "test_constraint_sheet.moc"
