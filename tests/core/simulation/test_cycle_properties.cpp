// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of MODEL-2…7 and 11 on whole cycles: what each radius, section and stage does by itself,
// when stages end, and how results add up; held against 10,000 random cycles each.
#include "tests/check_line.h"
#include "tests/core/simulation/random_cycles.h"
#include "tests/registry.h"

namespace sparkout::test_cycle_properties {

using namespace random_cycles;

class TestCycleProperties : public QObject {
    Q_OBJECT

    HeldFunctions m_held;

private slots:
    void cleanup() { m_held.count(); }
    void cleanupTestCase() {
        m_held.print("14", QStringLiteral("laws of whole cycles, each on %1 random ones")
                               .arg(QString::fromUtf8(qgetenv("RC_PARAMS").split('=').last())));
    }

    void initTestCase() { setRapidcheckRuns(10000); }

    // --- one radius, one section, one run at a time ----------------------------------------------

    void sameProjectGivesTheSameBitsWithAndWithoutATrajectory() {
        QVERIFY(holds("determinism", [] {
            const Project p = anyCycle();
            const SimulationResult first = simulateUnchecked(p);
            RC_ASSERT(fixtures::sameBits(first, simulateUnchecked(p)));
            RC_ASSERT(fixtures::sameBits(first, Traced(p).result));
        }));
    }

    // Whatever becomes of the others, a section goes its own way as long as the gauge's does.
    void sectionsDoNotFeelEachOther() {
        QVERIFY(holds("sections independent", [] {
            const Project p = anyPlunge(2);
            Project changed = p;
            auto& gammas = std::get<std::vector<double>>(changed.machine->compliance_mm_per_n);
            const int other = (*p.gauge->section + pick(1, p.sections)) % p.sections;
            gammas[std::size_t(other)] = decades(-6, -4);
            const SimulationResult a = simulateUnchecked(p);
            const SimulationResult b = simulateUnchecked(changed);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(a.gaugeReading_mm == b.gaugeReading_mm);
            for (int j = 0; j < p.sections; ++j) {
                if (j != other) {
                    RC_ASSERT(a.sections[std::size_t(j)].radii_mm
                              == b.sections[std::size_t(j)].radii_mm);
                }
            }
        }));
    }

    void zonesDoNotFeelEachOther() {
        QVERIFY(holds("zones independent", [] {
            const Project p = anyTraverse();
            Project changed = p;
            std::get<ZoneCompliance>(changed.machine->compliance_mm_per_n).rz1 = decades(-6, -3.7);
            changed.machine->dwell_entry_s = between(0, 1);
            const SimulationResult a = simulateUnchecked(p);
            const SimulationResult b = simulateUnchecked(changed);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(a.sections[1].radii_mm == b.sections[1].radii_mm);
            RC_ASSERT(a.sections[2].radii_mm == b.sections[2].radii_mm);
        }));
    }

    // The balance makes the depth after a pass rise with the depth before it and with t_П, and one
    // more pass never lowers it.
    void longerDwellRemovesMoreInTheReversalZone() {
        QVERIFY(holds("dwell", [] {
            const Project p = anyTraverse();
            Project longer = p;
            longer.machine->dwell_entry_s += between(0, 1);
            longer.machine->dwell_exit_s += between(0, 1);
            const SimulationResult a = simulateUnchecked(p);
            const SimulationResult b = simulateUnchecked(longer);
            const double passes = double(b.visits) / double(p.part->radii_per_section);
            const double off = rounding(0.5, passes) + radiusRounding_mm;
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(b.time_s >= a.time_s);
            const double side = p.part->surface == Surface::external ? 1 : -1;
            for (const std::size_t zone : {std::size_t(0), std::size_t(2)}) {
                for (std::size_t k = 0; k < a.sections[zone].radii_mm.size(); ++k) {
                    RC_ASSERT(side * (b.sections[zone].radii_mm[k] - a.sections[zone].radii_mm[k])
                              <= off);
                }
            }
        }));
    }

    // MODEL-9: by the balance the softer section ends larger (a bore: smaller).
    void softerSectionKeepsMoreStock() {
        QVERIFY(holds("softer", [] {
            const Traced run(anyPlunge());
            const double side = run.result.project.part->surface == Surface::external ? 1 : -1;
            const double off =
                rounding(programmed(run), double(run.trajectory.passes.size())) + radiusRounding_mm;
            for (const SectionResult& soft : run.result.sections) {
                for (const SectionResult& stiff : run.result.sections) {
                    for (std::size_t k = 0; k < soft.radii_mm.size(); ++k) {
                        RC_ASSERT((soft.compliance_mm_per_n < stiff.compliance_mm_per_n
                                   || side * (soft.radii_mm[k] - stiff.radii_mm[k]) >= -off));
                    }
                }
            }
        }));
    }

    // A bore and a shaft with the same depths of blank and the same D_e are one cycle; min and max
    // of the gauge's rule change places with the surface. D_e is the same to a few ε only, which
    // changes the depths by as little.
    void boreIsGroundAsItsMirroredShaft() {
        QVERIFY(holds("mirror", [] {
            Project shaft = anyPlunge();
            shaft.part->surface = Surface::external;
            shaft.part->diameter_mm = between(25, 130);
            shaft.part->profile = ProfileForm::measured;
            shaft.part->radii_um.emplace();
            for (int k = 0; k < shaft.part->radii_per_section; ++k) {
                shaft.part->radii_um->push_back(pick(-40, 1));
            }
            const double d = shaft.part->diameter_mm;
            const double De = d * between(0.2, 0.8);
            shaft.wheel->diameter_mm = d * De / (d - De);
            Project bore = shaft;
            bore.part->surface = Surface::internal;
            bore.wheel->diameter_mm = d * De / (d + De);
            for (double& deviation : *bore.part->radii_um) {
                deviation = -deviation;
            }
            const SimulationResult a = simulateUnchecked(shaft);
            const SimulationResult b = simulateUnchecked(bore);
            const double target = targetRadius(*shaft.part);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(within(a.remainingStock_mm, b.remainingStock_mm, balance_mm));
            for (std::size_t j = 0; j < a.sections.size(); ++j) {
                for (std::size_t k = 0; k < a.sections[j].radii_mm.size(); ++k) {
                    RC_ASSERT(within(a.sections[j].radii_mm[k] - target,
                                     target - b.sections[j].radii_mm[k], balance_mm));
                }
            }
        }));
    }

    // --- control ---------------------------------------------------------------------------------

    // Under position control the feed ends where the stocks say, to the rounding of the sum of its
    // steps; a step shorter than the 1e-9 mm of every threshold [MODEL-7] is not made. Nothing is
    // cut past the end.
    void positionControlEndsExactlyAtTheTotalInfeed() {
        QVERIFY(holds("position control", [] {
            Project p = anyCycle();
            p.gauge->control = Control::position;
            double sum = 0;
            for (Stage& stage : p.cycle->stages) {
                if (stage.spark_out.mode != SparkOut::Mode::none) {
                    stage.stock_mm = 0;
                }
                sum += stage.stock_mm;
            }
            p.part->stock_mm = sum;
            const Traced run(p);
            const Blank blank = makeBlank(*p.part);
            RC_ASSERT(run.result.status == RunStatus::completed);
            const double off = rounding(blank.totalInfeed_mm, double(run.trajectory.passes.size()));
            const double left = blank.totalInfeed_mm - programmed(run);
            RC_ASSERT(left >= -off);
            RC_ASSERT(left <= threshold_mm + off);
            RC_ASSERT(run.result.remainingStock_mm >= -off);
        }));
    }

    // Step by step: a stage goes on while its threshold is not reached, and ends as soon as it is.
    // Thresholds carry 1e-9 mm; the readings here come from rounded radii.
    void everyStageRunsUntilItsThresholdAndNotOneStepLonger() {
        QVERIFY(holds("stages", [] {
            Project p = anyCycle();
            p.gauge->control = Control::gauge;
            const Traced run(p);
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge->section;
            const std::size_t stages = p.cycle->stages.size();
            std::vector<double> later(stages + 1), readings;
            std::vector<int> stageOf, counts(stages);
            for (std::size_t z = stages; z-- > 0;) {
                later[z] = z + 1 == stages ? 0 : later[z + 1] + p.cycle->stages[z + 1].stock_mm;
            }
            for (const Pass& pass : run.passesOf(gauged)) {
                const std::size_t step = std::size_t(pass.place.cycleCount);
                readings.resize(step);
                stageOf.resize(step);
                std::vector<double> R;
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    R.push_back(run.visit(pass, k).radius_mm);
                }
                readings[step - 1] = remaining(p, R);
                stageOf[step - 1] = pass.place.stage - 1;
            }
            constexpr double off = 4 * radiusRounding_mm;
            for (std::size_t step = 0; step < readings.size(); ++step) {
                const std::size_t z = std::size_t(stageOf[step]);
                const std::size_t next =
                    step + 1 < readings.size() ? std::size_t(stageOf[step + 1]) : stages;
                ++counts[z];
                RC_ASSERT(next >= z);
                for (std::size_t ended = z; ended < next; ++ended) {
                    const SparkOut& spark = p.cycle->stages[ended].spark_out;
                    const bool ends = spark.mode == SparkOut::Mode::count
                                          ? counts[ended] == spark.count
                                          : readings[step] <= later[ended] + threshold_mm + off;
                    RC_ASSERT(ends);
                }
                if (next < stages && p.cycle->stages[next].spark_out.mode == SparkOut::Mode::none) {
                    RC_ASSERT(readings[step] > later[next] + threshold_mm - off);
                }
            }
            RC_ASSERT(run.result.status == RunStatus::completed);
            RC_ASSERT(run.result.countsByStage == counts);
            RC_ASSERT(within(run.result.remainingStock_mm, readings.back(), off));
        }));
    }

    // The reading before the last step was above size, so what lies below size was cut in that
    // step.
    void overshootIsLessThanWhatTheLastStepCut() {
        QVERIFY(holds("overshoot", [] {
            Project p = anyCycle();
            p.gauge->control = Control::gauge;
            p.cycle->stages.back().spark_out = {};
            const Traced run(p);
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge->section;
            std::vector<double> cut(std::size_t(run.trajectory.radii));
            for (const Pass& pass : run.passesOf(gauged)) {
                if (pass.place.cycleCount == run.result.cycleCount) {
                    for (int k = 0; k < run.trajectory.radii; ++k) {
                        cut[std::size_t(k)] += run.visit(pass, k).actual_mm;
                    }
                }
            }
            const double most = *std::max_element(cut.begin(), cut.end());
            RC_ASSERT(run.result.remainingStock_mm <= 1e-9);
            RC_ASSERT(run.result.remainingStock_mm > -most);
        }));
    }

    // --- bookkeeping -----------------------------------------------------------------------------

    void resultAddsUp() {
        QVERIFY(holds("sums", [] {
            const Traced run(anyCycle());
            const SimulationResult& r = run.result;
            const Project& p = r.project;
            RC_ASSERT(std::accumulate(r.countsByStage.begin(), r.countsByStage.end(), 0)
                      == r.cycleCount);
            const double time =
                std::accumulate(r.timeByStage_s.begin(), r.timeByStage_s.end(), 0.0);
            const double passes = double(run.trajectory.passes.size());
            RC_ASSERT(close(time, r.time_s, fixtures::epsilon * passes));
            RC_ASSERT(r.visits == static_cast<long long>(run.trajectory.visits.size()));
            RC_ASSERT(run.trajectory.visits.size()
                      == run.trajectory.passes.size() * std::size_t(run.trajectory.radii));
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge->section;
            RC_ASSERT(within(r.remainingStock_mm,
                             remaining(p, r.sections[std::size_t(gauged)].radii_mm),
                             4 * radiusRounding_mm));
            const double side = p.part->surface == Surface::external ? 1 : -1;
            RC_ASSERT(within(r.gaugeReading_mm / 2,
                             targetRadius(*p.part) + side * r.remainingStock_mm,
                             radiusRounding_mm));
            double last = 0;
            for (const Visit& visit : run.trajectory.visits) {
                last = std::max(last, visit.time_s);
            }
            RC_ASSERT(last <= r.time_s * (1 + fixtures::epsilon * passes));
        }));
    }

    // MODEL-7: deviations of all diameters, runout about the axis plus the machine's own.
    void sectionsAreMeasuredAsTheDrawingSays() {
        QVERIFY(holds("measures", [] {
            Project p = anyCycle();
            p.machine->geometric_runout_um = oneIn(2) ? 0 : between(0, 5);
            for (const SectionResult& s : simulateUnchecked(p).sections) {
                const std::size_t K = s.radii_mm.size();
                double low = 1e9, high = 0;
                for (std::size_t k = 0; k < K; ++k) {
                    const double D = s.radii_mm[k] + s.radii_mm[(k + K / 2) % K];
                    low = std::min(low, D);
                    high = std::max(high, D);
                }
                const auto [least, most] =
                    std::minmax_element(s.radii_mm.begin(), s.radii_mm.end());
                RC_ASSERT(s.diameterDeviationMin_mm == low - p.part->diameter_mm);
                RC_ASSERT(s.diameterDeviationMax_mm == high - p.part->diameter_mm);
                RC_ASSERT(within(s.radialRunout_mm,
                                 *most - *least + p.machine->geometric_runout_um / 1000,
                                 4 * fixtures::epsilon));
            }
        }));
    }
};

} // namespace sparkout::test_cycle_properties

SPARKOUT_TEST(test_cycle_properties, TestCycleProperties)
#include "test_cycle_properties.moc"
