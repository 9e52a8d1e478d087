// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/requirement.h"

#include "core/project/member.h"
#include "core/quality/constraints.h"
#include "core/quality/limit_series.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/random_project.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_requirement_rows {

/// With everything required.
Project demanding(Project project) {
    project.part->tolerance = {};
    for (std::optional<double> Tolerance::*limit :
         {&Tolerance::roundness_um, &Tolerance::radial_runout_um, &Tolerance::cylindricity_um,
          &Tolerance::total_runout_um, &Tolerance::waviness_um, &Tolerance::roughness_ra_um}) {
        project.part->tolerance.*limit = 5;
    }
    project.material->burn_rise_k = 500;
    project.wheel->grain_surface_energy_j_m2 = 20;
    project.wheel->grain_modulus_gpa = 400;
    project.wheel->bond_surface_energy_j_m2 = 5;
    project.wheel->bond_modulus_gpa = 60;
    project.machine->wheel_drive_kw = 3;
    project.machine->work_drive_kw = 0.05;
    project.machine->limits.radial_feed_mm = {0.0005, 0.02, 0.0005};
    project.machine->limits.axial_feed_mm_min = {50, 5000, 50};
    project.machine->limits.plunge_feed_mm_min = {0.02, 5, 0.01};
    project.machine->limits.continuous_feed_mm_min = {0.01, 1, 0.01};
    for (Stage& stage : project.cycle->stages) {
        if (project.operation->travels) {
            stage.continuous_feed_mm_min = 0.02;
        }
    }
    project.machine->limits.work_speed_rpm = {50, 500, 5};
    project.gauge->control = Control::gauge;
    project.least_overlap = 1.05;
    project.least_overlap_last = 2;
    project.least_steps = 2;
    return project;
}

std::vector<Project> demandingProjects() {
    return {demanding(fixtures::traverse()), demanding(fixtures::plunge())};
}

std::set<ConstraintKind> kindsOf(const std::vector<ConstraintResult>& results) {
    std::set<ConstraintKind> kinds;
    for (const ConstraintResult& each : results) {
        kinds.insert(each.kind);
    }
    return kinds;
}

class TestRequirementRows : public QObject {
    Q_OBJECT

private slots:
    void aRowIsFoundByItsKindAndByItsKey() {
        for (const Requirement& row : requirementRows) {
            QCOMPARE(&requirementOf(row.kind), &row);
            QCOMPARE(requirementNamed(row.key), &row);
            QVERIFY(*row.label && *row.brief && row.evaluate);
            QVERIFY(!row.limitName == !row.depthLimit);
        }
        QVERIFY(!requirementNamed("diameter") && !requirementNamed(""));
    }

    void itsInputsAndSettingsAreMembersOfTheProject() {
        const Project project = fixtures::traverse();
        for (const Requirement& row : requirementRows) {
            for (const Requirement::Paths& paths : {row.inputs, row.estimates}) {
                for (const char* path : paths) {
                    QVERIFY2(!path || findMember(project, path), path);
                }
            }
            QVERIFY(!row.setting || findMember(project, row.setting));
            QVERIFY(!row.settingOfStage || tableOf<Stage>().find(row.settingOfStage));
            QCOMPARE(row.scope == ConstraintScope::setting, row.setting || row.settingOfStage);
        }
    }

    // limit − value, of a least limit value − limit, whatever the requirement; positive where it
    // holds, up to the slack of rounding.
    void aMarginIsTheWayToTheLimit() {
        std::set<ConstraintKind> met;
        std::vector<Project> projects = demandingProjects();
        for (int seed = 0; seed < samples::sized(60, 10, 600); ++seed) {
            const auto read = readProject(randomProject(std::uint64_t(seed)).dump());
            projects.push_back(read.project.value());
        }
        for (const Project& project : projects) {
            for (const ConstraintResult& each : evaluateConstraints(simulate(project))) {
                const Requirement& row = requirementOf(each.kind);
                QCOMPARE(each.margin,
                         each.isLeast ? each.value - each.limit : each.limit - each.value);
                QVERIFY(!each.holds || each.margin >= -1e-5);
                QVERIFY(each.holds || !each.isWhole || each.margin < 0);
                QVERIFY(each.isLeast == row.isLeast || row.source == LimitSource::range);
                QCOMPARE(each.otherEnd.has_value(), row.source == LimitSource::range);
                if (row.source == LimitSource::input) {
                    QCOMPARE(each.limit, statedLimit(row, project).value());
                }
                met.insert(each.kind);
            }
        }
        QCOMPARE(met.size(), requirementRows.size());
    }

    // Each is on exactly where its inputs are given, and so is its limit of the depth of cut.
    void withoutAnInputItIsOff() {
        for (const Project& all : demandingProjects()) {
            const std::set<ConstraintKind> on = kindsOf(evaluateConstraints(simulate(all)));
            for (const Requirement& row : requirementRows) {
                QCOMPARE(missingInput(row, all), std::string());
                for (const char* path : row.inputs) {
                    Project without = all;
                    const Member member = path ? findMember(without, path) : Member();
                    if (member
                        && (member.field->kind == Kind::optionalNumber
                            || member.field->kind == Kind::optionalInteger)) {
                        setNumberIn(*member.field, member.owner, std::nullopt);
                    } else if (member && member.field->kind == Kind::optionalNumberList) {
                        member.field->as<std::optional<std::vector<double>>>(member.owner).reset();
                    } else {
                        continue;
                    }
                    QCOMPARE(missingInput(row, without), std::string(path));
                    std::set<ConstraintKind> left = on;
                    if (left.erase(row.kind) > 0 && row.kind == ConstraintKind::leastOverlap) {
                        left.insert(ConstraintKind::overlap); // now all that is required of stages
                    }
                    QCOMPARE(kindsOf(evaluateConstraints(simulate(without))), left);
                    QVERIFY(!row.depthLimit || !row.depthLimit(without, 1, 0.1));
                    QVERIFY(!row.passBound || !row.passBound(without));
                }
            }
        }
    }

    // First those of every pass: only the last cut's roughness comes behind them.
    void limitsOfTheDepthOfCutAreInTheirOrder() {
        const std::vector<ConstraintKind> kinds = depthLimitKinds();
        const auto last = std::ranges::find_if(
            kinds, [](ConstraintKind kind) { return !requirementOf(kind).bindsEveryPass(); });
        QCOMPARE(kinds.end() - last, std::ptrdiff_t(1));
        QVERIFY(*last == ConstraintKind::roughness);
        std::set<ConstraintKind> limiting;
        for (const DepthLimit& limit : depthLimits(demanding(fixtures::plunge()), 1, 0.1)) {
            limiting.insert(limit.kind);
        }
        QCOMPARE(std::set(kinds.begin(), kinds.end()), limiting);
    }
};

} // namespace sparkout::test_requirement_rows

SPARKOUT_TEST(test_requirement_rows, TestRequirementRows)
#include "test_requirement_rows.moc"
