// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraints.h"
#include "core/quality/drawing_constraints.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_constraints {

using fixtures::within;

// Values are some µm and come out of two or three operations.
constexpr double um = 1e-13;

/// Two sections within the field 0/−16 µm, runouts 3 and 5 µm.
SimulationResult result() {
    SimulationResult r;
    r.project = fixtures::plunge();
    r.project.gauge->control = Control::position; // no gauge commands to count
    r.project.part->upper_deviation_um = 0;
    r.project.part->lower_deviation_um = -16;
    r.project.part->tolerance.radial_runout_um = 6;
    SectionResult section;
    section.diameterDeviationMin_mm = -0.010;
    section.diameterDeviationMax_mm = -0.004;
    section.radialRunout_mm = 0.003;
    r.sections.push_back(section);
    section.diameterDeviationMin_mm = -0.012;
    section.diameterDeviationMax_mm = -0.007;
    section.radialRunout_mm = 0.005;
    r.sections.push_back(section);
    return r;
}

const ConstraintResult& find(const std::vector<ConstraintResult>& all, ConstraintKind kind,
                             int section) {
    for (const ConstraintResult& c : all) {
        if (c.kind == kind && c.section == section) {
            return c;
        }
    }
    static const ConstraintResult none{};
    return none;
}

class TestConstraints : public QObject {
    Q_OBJECT

private slots:
    /// Circles about the axis, or about any other centre, hold the minimum zone.
    void anUpperBoundOfRoundnessIsTakenWhereItIsClearOfTheLimit() {
        int bounded = 0, exactly = 0;
        constexpr double clear_um = 0.02;
        for (int i = 0; i < 40; ++i) {
            Project p = fixtures::plunge();
            p.part->initial_runout_mm = 0.02 + 0.004 * i;
            p.part->profile = static_cast<ProfileForm>(i % 3);
            SimulationResult run = simulateUnchecked(p);
            const std::vector<SectionAccuracy> exact = accuracyOf(run).sections;
            for (const double share : {0.5, 0.99, 1.2, 2.0, 10.0}) {
                const double form_um = 1000 * exact[0].minimumZone.deviation();
                const double limit_um = share * form_um + clear_um;
                run.project.part->tolerance.roundness_um = limit_um;
                const double all_um =
                    1000 * requiredAccuracy(run).sections[0].minimumZone.deviation();
                const double told_um =
                    1000 * requiredAccuracy(run, clear_um).sections[0].minimumZone.deviation();
                QCOMPARE(all_um, form_um);
                QVERIFY(told_um == form_um
                        || (told_um > form_um - 1e-9 && told_um < limit_um - clear_um));
                (told_um == form_um ? exactly : bounded) += 1;
            }
        }
        QVERIFY2(bounded > 30 && exactly > 50,
                 QByteArray::number(bounded) + ' ' + QByteArray::number(exactly));
    }

    void everySectionIsHeldAgainstEveryLimit() {
        const auto all = evaluateConstraints(result());
        QCOMPARE(all.size(), std::size_t(6));
        for (int j = 0; j < 2; ++j) {
            for (const ConstraintKind kind :
                 {ConstraintKind::diameterMin, ConstraintKind::diameterMax,
                  ConstraintKind::radialRunout}) {
                QVERIFY(find(all, kind, j).kind == kind && find(all, kind, j).holds);
            }
        }
    }

    void marginIsTheDistanceToTheLimitFromInside_data() {
        addColumns<ConstraintKind, int, double, double, double, double>(
            "kind", "section", "limit", "value", "margin", "relative");
        addRow("min 0", ConstraintKind::diameterMin, 0, -16.0, -10.0, 6.0, 6.0 / 16);
        addRow("min 1", ConstraintKind::diameterMin, 1, -16.0, -12.0, 4.0, 4.0 / 16);
        addRow("max 0", ConstraintKind::diameterMax, 0, 0.0, -4.0, 4.0, 4.0 / 16);
        addRow("max 1", ConstraintKind::diameterMax, 1, 0.0, -7.0, 7.0, 7.0 / 16);
        addRow("runout 0", ConstraintKind::radialRunout, 0, 6.0, 3.0, 3.0, 3.0 / 6);
        addRow("runout 1", ConstraintKind::radialRunout, 1, 6.0, 5.0, 1.0, 1.0 / 6);
    }
    void marginIsTheDistanceToTheLimitFromInside() {
        QFETCH(ConstraintKind, kind);
        QFETCH(int, section);
        QFETCH(double, limit);
        QFETCH(double, value);
        QFETCH(double, margin);
        QFETCH(double, relative);
        const auto all = evaluateConstraints(result());
        const ConstraintResult& c = find(all, kind, section);
        QVERIFY(c.holds);
        QCOMPARE(c.section, section);
        QVERIFY(within(c.limit, limit, um) && within(c.value, value, um));
        QVERIFY(within(c.margin, margin, um) && within(c.relativeMargin, relative, um));
    }

    void marginIsNegativeBeyondTheLimit() {
        SimulationResult r = result();
        r.sections[0].diameterDeviationMin_mm = -0.018;
        r.sections[0].diameterDeviationMax_mm = 0.003;
        r.sections[0].radialRunout_mm = 0.0065;
        const auto all = evaluateConstraints(r);
        const std::pair<ConstraintKind, double> expected[] = {{ConstraintKind::diameterMin, -2},
                                                              {ConstraintKind::diameterMax, -3},
                                                              {ConstraintKind::radialRunout, -0.5}};
        for (const auto& [kind, margin] : expected) {
            QVERIFY(!find(all, kind, 0).holds);
            QVERIFY(within(find(all, kind, 0).margin, margin, um));
            QVERIFY(find(all, kind, 1).holds);
        }
    }

    // MODEL-8: each diameter within [lower, upper] + 1e-9 mm
    void slackOfAMillionthOfAMicrometreFailsNobody_data() {
        addColumns<double, bool>("beyond_mm", "holds");
        addRow("on the limit", 0.0, true);
        addRow("inside the slack", 0.9e-9, true);
        addRow("outside the slack", 1.1e-9, false);
    }
    void slackOfAMillionthOfAMicrometreFailsNobody() {
        QFETCH(double, beyond_mm);
        QFETCH(bool, holds);
        SimulationResult r = result();
        r.sections[0].diameterDeviationMin_mm = -0.016 - beyond_mm;
        r.sections[1].diameterDeviationMax_mm = 0.0 + beyond_mm;
        r.sections[1].radialRunout_mm = 0.006 + beyond_mm;
        const auto all = evaluateConstraints(r);
        QCOMPARE(find(all, ConstraintKind::diameterMin, 0).holds, holds);
        QCOMPARE(find(all, ConstraintKind::diameterMax, 1).holds, holds);
        QCOMPARE(find(all, ConstraintKind::radialRunout, 1).holds, holds);
    }

    void toleranceThatIsNotGivenIsNotListed() {
        SimulationResult r = result();
        r.project.part->tolerance.radial_runout_um.reset();
        const auto all = evaluateConstraints(r);
        QCOMPARE(all.size(), std::size_t(4));
        for (const ConstraintResult& c : all) {
            QVERIFY(c.kind != ConstraintKind::radialRunout);
        }
        QCOMPARE(worstByKind(all).size(), std::size_t(2));
    }

    void zoneAndSectionSayWhere() {
        Project p = fixtures::traverse();
        const auto all = evaluateConstraints(simulateUnchecked(p));
        for (int j = 0; j < 3; ++j) {
            QCOMPARE(find(all, ConstraintKind::diameterMin, j).zone, Zone(j));
        }
        for (const ConstraintResult& c :
             evaluateConstraints(simulateUnchecked(fixtures::plunge()))) {
            QCOMPARE(c.zone, Zone::section);
        }
    }

    void worstOfEachKindIsListedInTheOrderOfTheKinds() {
        const auto worst = worstByKind(evaluateConstraints(result()));
        QCOMPARE(worst.size(), std::size_t(3));
        QVERIFY(worst[0].kind == ConstraintKind::diameterMin && worst[0].section == 1);
        QVERIFY(worst[1].kind == ConstraintKind::diameterMax && worst[1].section == 0);
        QVERIFY(worst[2].kind == ConstraintKind::radialRunout && worst[2].section == 1);
        QVERIFY(worstByKind({}).empty());
    }

    void namesAreThoseOfTheFile() {
        const std::vector<std::string> names = samples::listOf(
            "diameter_min|diameter_max|radial_runout|roundness|cylindricity|total_runout|"
            "waviness|roughness|burn|self_sharpening|wheel_power|work_power|range_radial_feed|"
            "range_axial_feed|range_plunge_feed|range_continuous_feed|range_work_speed|"
            "gauge_commands|overlap|least_overlap|least_overlap_last|least_steps");
        QCOMPARE(names.size(), static_cast<std::size_t>(constraintKinds));
        for (int kind = 0; kind < constraintKinds; ++kind) {
            QCOMPARE(std::string(requirementOf(static_cast<ConstraintKind>(kind)).key),
                     names[static_cast<std::size_t>(kind)]);
        }
    }

    // B·n/S_ax ≥ 1 in every stage; below it strips stay uncut, and nothing that is held against
    // the surface is known of the whole of it.
    void stripsThatStayUncutFailAndLeaveTheSizeUnknown() {
        Project p = fixtures::traverse();
        p.part->tolerance.roughness_ra_um = 50;
        p.part->tolerance.cylindricity_um = 500;
        p.part->lower_deviation_um = -900;
        p.part->upper_deviation_um = 900;
        const double most = p.wheel->width_mm * p.machine->work_speed_rpm;
        const double others = *p.cycle->stages.back().axial_feed_mm_min;
        QVERIFY(others < most && p.cycle->stages.size() > 1);
        for (std::size_t stage = 0; stage < p.cycle->stages.size(); ++stage) {
            Project q = p;
            for (const double share : {0.5, 1.0, 1.0001, 3.0}) {
                q.cycle->stages[stage].axial_feed_mm_min = share * most;
                const bool strips = share > 1;
                const auto all = evaluateConstraints(simulateUnchecked(q));
                QCOMPARE(std::ranges::count(all, ConstraintKind::overlap, &ConstraintResult::kind),
                         static_cast<std::ptrdiff_t>(q.cycle->stages.size()));
                for (const ConstraintResult& each : all) {
                    const bool ofTheSurface =
                        requirementOf(each.kind).scope == ConstraintScope::section
                        || requirementOf(each.kind).scope == ConstraintScope::part;
                    QCOMPARE(each.isWhole, !(strips && ofTheSurface));
                    QVERIFY(each.isWhole || !each.holds);
                    if (each.kind == ConstraintKind::overlap
                        && each.stage == static_cast<int>(stage) + 1) {
                        QCOMPARE(each.holds, !strips);
                        QVERIFY(fixtures::close(each.value, 1 / share, 1e-12));
                        QCOMPARE(each.limit, 1.0);
                    } else if (each.kind == ConstraintKind::overlap) {
                        QVERIFY(each.holds);
                    }
                }
            }
        }
        Project plunge = fixtures::plunge();
        for (const ConstraintResult& each : evaluateConstraints(simulateUnchecked(plunge))) {
            QVERIFY(each.kind != ConstraintKind::overlap && each.isWhole);
        }
    }

    // Of strips 1, whatever more is required; else the greatest that is required of the stage.
    void aStageIsHeldAgainstTheOneOverlapThatCounts() {
        const Project p = fixtures::traverse();
        const double most = p.wheel->width_mm * p.machine->work_speed_rpm;
        const std::optional<double> leasts[] = {std::nullopt, 1.0, 1.05, 2.0, 3.5};
        for (const double overlap : {0.8, 1.0, 1.05, 1.7, 2.0, 5.0}) {
            for (const auto& every : leasts) {
                for (const auto& last : leasts) {
                    Project q = p;
                    q.least_overlap = every;
                    q.least_overlap_last = last;
                    for (Stage& stage : q.cycle->stages) {
                        stage.axial_feed_mm_min = most / overlap;
                    }
                    SimulationResult r;
                    r.project = q;
                    std::vector<int> times(q.cycle->stages.size());
                    for (const ConstraintResult& each : evaluateConstraints(r)) {
                        const bool ofOverlap = each.kind == ConstraintKind::overlap
                                               || each.kind == ConstraintKind::leastOverlap
                                               || each.kind == ConstraintKind::leastOverlapLast;
                        if (!ofOverlap) {
                            continue;
                        }
                        const std::size_t z = static_cast<std::size_t>(each.stage) - 1;
                        ++times.at(z);
                        const bool isLast = z + 1 == times.size();
                        const double least = overlap < 1
                                                 ? 1
                                                 : std::max({1.0, every.value_or(1),
                                                             isLast ? last.value_or(1) : 1.0});
                        QCOMPARE(each.limit, least);
                        QVERIFY(fixtures::close(each.value, overlap, 1e-12));
                        QCOMPARE(each.holds, overlap >= least);
                        QVERIFY(each.isLeast && each.isWhole);
                        QCOMPARE(each.kind == ConstraintKind::overlap,
                                 overlap < 1 || !(every || (isLast && last)));
                    }
                    QVERIFY(times == std::vector<int>(times.size(), 1));
                }
            }
        }
    }

    void theStageThatMakesTheFewestStepsIsHeldAgainstTheLeast() {
        Project p = fixtures::traverse();
        p.least_steps = 2;
        const auto found = [](const Project& project) {
            return find(evaluateConstraints(simulateUnchecked(project)), ConstraintKind::leastSteps,
                        -1);
        };
        const SimulationResult run = simulateUnchecked(p);
        const auto fewest = std::ranges::min_element(run.countsByStage);
        QCOMPARE(found(p).value, double(*fewest));
        QCOMPARE(found(p).stage, int(fewest - run.countsByStage.begin()) + 1);
        QVERIFY(found(p).holds && found(p).isLeast);
        p.least_steps = *fewest;
        QVERIFY(found(p).holds);
        p.least_steps = *fewest + 1;
        QVERIFY(!found(p).holds);
        QCOMPARE(found(p).margin, -1.0);
        Project sparks = p; // its number is set
        sparks.cycle->stages.push_back(
            fixtures::sparkStage(fixtures::count(1), 0.001, p.cycle->stages[1].axial_feed_mm_min));
        QVERIFY(found(sparks).value > 1);
        Project over = p; // the size is reached before it
        over.cycle->stages[0].stock_mm = 0;
        over.cycle->stages[1].stock_mm = 0.15;
        over.cycle->stages[1].radial_feed_mm = 1;
        over.cycle->stages.push_back(over.cycle->stages[1]);
        over.cycle->stages[2].stock_mm = 1e-4;
        QVERIFY(found(over).stage == 3 && found(over).value == 0 && !found(over).holds);
        over.cycle->stages[1].stock_mm = over.cycle->stages[2].stock_mm = 0; // none has stock
        for (const ConstraintResult& each : evaluateConstraints(simulateUnchecked(over))) {
            QVERIFY(each.kind != ConstraintKind::leastSteps);
        }
    }

    void machinesRunoutCountsAgainstTheTolerance() {
        Project p = fixtures::plunge();
        p.part->tolerance.radial_runout_um = 3;
        const auto alone = evaluateConstraints(simulateUnchecked(p));
        p.machine->geometric_runout_um = 2;
        const auto together = evaluateConstraints(simulateUnchecked(p));
        const double difference = find(together, ConstraintKind::radialRunout, 0).value
                                  - find(alone, ConstraintKind::radialRunout, 0).value;
        QVERIFY(within(difference, 2, 1e-12));
    }

    void machinesRunoutCountsAgainstTheTotalRunout() {
        Project p = fixtures::plunge();
        p.part->tolerance.total_runout_um = 3;
        const auto alone = evaluateConstraints(simulateUnchecked(p));
        p.machine->geometric_runout_um = 2;
        const auto together = evaluateConstraints(simulateUnchecked(p));
        const double difference = find(together, ConstraintKind::totalRunout, -1).value
                                  - find(alone, ConstraintKind::totalRunout, -1).value;
        QVERIFY(within(difference, 2, 1e-12));
    }

    void roundnessIsThatOfItsOwnSection() {
        SimulationResult r = result();
        r.project.part->tolerance.roundness_um = 20;
        for (std::size_t j = 0; j < 2;
             ++j) { // three lobes, which no shift of the centre takes away
            for (int k = 0; k < 36; ++k) {
                const double form_mm = j == 0 ? 0.001 : 0.004;
                r.sections[j].radii_mm.push_back(15 + form_mm * std::cos(3 * k * 2 * M_PI / 36));
            }
        }
        const auto all = evaluateConstraints(r);
        QVERIFY(within(find(all, ConstraintKind::roundness, 0).value, 2, 0.05));
        QVERIFY(within(find(all, ConstraintKind::roundness, 1).value, 8, 0.05));
    }

    // --- what is set at the machine -------------------------------------------------------------

    void asManyStagesAsCommandsHold() {
        SimulationResult r = result();
        r.project.gauge->control = Control::gauge;
        r.project.cycle->stages.assign(3, fixtures::plungeStage(0.5, 0.1));
        for (const int commands : {2, 3, 4}) {
            r.project.gauge->commands = commands;
            const auto all = evaluateConstraints(r);
            QCOMPARE(find(all, ConstraintKind::gaugeCommands, -1).holds, commands >= 3);
        }
    }

    void aSettingIsHeldAgainstItsNearerEnd_data() {
        addColumns<double, double, bool>("speed", "limit", "isLeast");
        addRow("below", 40.0, 50.0, true);
        addRow("at the bottom", 50.0, 50.0, true);
        addRow("near the bottom", 90.0, 50.0, true);
        addRow("near the top", 450.0, 500.0, false);
        addRow("at the top", 500.0, 500.0, false);
        addRow("above", 600.0, 500.0, false);
    }
    void aSettingIsHeldAgainstItsNearerEnd() {
        QFETCH(double, speed);
        QFETCH(double, limit);
        QFETCH(bool, isLeast);
        SimulationResult r = result();
        r.project.machine->limits.work_speed_rpm = {50, 500, 5};
        r.project.machine->work_speed_rpm = speed;
        const ConstraintResult found =
            find(evaluateConstraints(r), ConstraintKind::rangeWorkSpeed, -1);
        QCOMPARE(found.limit, limit);
        QCOMPARE(found.isLeast, isLeast);
        QCOMPARE(found.holds, speed >= 50 && speed <= 500);
    }

    // P_z·V_k and P_z·V_d of the same force.
    void theDrivesPowersAreInTheRatioOfTheirSpeeds() {
        SimulationResult r = result();
        r.peakPower_w = 2400;
        r.project.machine->wheel_drive_kw = 3;
        r.project.machine->work_drive_kw = 0.05;
        const auto all = evaluateConstraints(r);
        const double Vd = M_PI * r.project.part->diameter_mm * r.project.machine->work_speed_rpm
                          / 60 / 1000; // m/s
        QVERIFY(within(find(all, ConstraintKind::wheelPower, -1).value, 2.4, 1e-12));
        QVERIFY(within(find(all, ConstraintKind::workPower, -1).value,
                       2.4 * Vd / r.project.machine->wheel_speed_m_s, 1e-12));
        for (const ConstraintKind kind : {ConstraintKind::wheelPower, ConstraintKind::workPower}) {
            QVERIFY(!find(all, kind, -1).isLeast);
        }
        QVERIFY(find(all, ConstraintKind::diameterMin, 0).isLeast);
        QVERIFY(!find(all, ConstraintKind::diameterMax, 0).isLeast);
    }
};

} // namespace sparkout::test_constraints

SPARKOUT_TEST(test_constraints, TestConstraints)
#include "test_constraints.moc"
