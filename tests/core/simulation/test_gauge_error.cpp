// SPDX-License-Identifier: GPL-3.0-or-later
// A gauge that reads wrong, and a part that is warm when it is read: held against the same cycle of
// another part, for which no reading is wrong.
#include "core/phases/phase_decision.h"
#include "core/project/gauge.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/random_project.h"
#include "tests/registry.h"

#include <cmath>
#include <string>
#include <vector>

namespace sparkout::test_gauge_error {

using fixtures::within;

/// The part at whose size a gauge without error ends the cycle where the one that reads so much too
/// large ends that of the project: the first touch stays where it is.
Project shifted(Project project, double tooLarge_mm) {
    Part& part = *project.part;
    const double sign = part.surface == Surface::external ? 1 : -1;
    const double middle_mm =
        part.diameter_mm + (part.upper_deviation_um + part.lower_deviation_um) / 2 / 1000;
    part.target_diameter_mm = part.target_diameter_mm.value_or(middle_mm) - tooLarge_mm;
    part.stock_mm += sign * tooLarge_mm / 2;
    project.gauge->error_um = 0;
    project.gauge->part_warmer_k = 0;
    return project;
}

/// What differs between two results by more than rounding; empty: nothing.
std::string differenceOf(const SimulationResult& a, const SimulationResult& b) {
    if (a.status != b.status || a.countsByStage != b.countsByStage) {
        return "status or steps";
    }
    if (!within(a.time_s, b.time_s, 1e-9) || !within(a.peakPower_w, b.peakPower_w, 1e-6)) {
        return "time or power";
    }
    if (a.sections.size() != b.sections.size()) {
        return "sections";
    }
    for (std::size_t i = 0; i < a.sections.size(); ++i) {
        const auto &one = a.sections[i].radii_mm, &other = b.sections[i].radii_mm;
        for (std::size_t k = 0; k < one.size(); ++k) {
            if (std::isnan(one[k]) != std::isnan(other[k])
                || (!std::isnan(one[k]) && !within(one[k], other[k], 1e-10))) {
                return "radii";
            }
        }
    }
    if (a.status != RunStatus::completed) {
        return {};
    }
    const auto held = evaluateConstraints(a), heldThere = evaluateConstraints(b);
    if (held.size() != heldThere.size()) {
        return "requirements";
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (!within(held[i].margin, heldThere[i].margin, 1e-6 * (1 + std::abs(held[i].limit)))) {
            return requirementOf(held[i].kind).key;
        }
    }
    return {};
}

Project bore() {
    Project p = fixtures::plungeOfThree();
    p.part->surface = Surface::internal;
    p.part->diameter_mm = 60;
    p.wheel->diameter_mm = 45;
    return p;
}

class TestGaugeError : public QObject {
    Q_OBJECT

private slots:
    void readingIsThatOfAnotherPart() {
        int compared = 0;
        for (Project p :
             {fixtures::plunge(), fixtures::plungeOfThree(), fixtures::traverse(), bore()}) {
            p.material->burn_rise_k = 700;
            for (const double error_um : {-6.3, -0.4, 0.7, 5.0}) {
                p.gauge->error_um = error_um;
                const std::string found =
                    differenceOf(simulate(p), simulate(shifted(p, error_um / 1000)));
                QVERIFY2(found.empty(), found.c_str());
                ++compared;
            }
        }
        QCOMPARE(compared, 16);
    }

    /// Every option of the cycle.
    void readingOfRandomProjectsIsThatOfAnotherPart() {
        int gauged = 0;
        for (std::uint64_t seed = 1; seed <= 120; ++seed) {
            const auto read = readProject(randomProject(seed).dump());
            Project p = *read.project;
            const double most_um = 500 * p.part->stock_mm;
            p.gauge->error_um = (seed % 2 == 0 ? 0.04 : -0.03) * most_um;
            p.gauge->part_warmer_k = 1.5;
            const bool isGauged = p.gauge->control == Control::gauge;
            const Project other = isGauged ? shifted(p, readsTooLarge_mm(p)) : p;
            if (hasErrors(validate(p)) || hasErrors(validate(other)) || p.part->zone_stock_mm) {
                continue;
            }
            if (isGauged) {
                const std::string found = differenceOf(simulate(p), simulate(other));
                QVERIFY2(found.empty(), (std::to_string(seed) + ": " + found).c_str());
                ++gauged;
            } else if (!p.cycle->stages.back().waitsForSize()) {
                Project right = p;
                right.gauge->error_um = right.gauge->part_warmer_k = 0;
                QVERIFY(std::ranges::equal(simulate(p).sections.front().radii_mm,
                                           simulate(right).sections.front().radii_mm,
                                           [](double a, double b) { // no radius in a gap
                                               return a == b || (std::isnan(a) && std::isnan(b));
                                           }));
            }
        }
        QVERIFY2(gauged > 40, std::to_string(gauged).c_str());
    }

    /// 11.5 µm/(m·K) · 30 mm · 4 K = 1.38 µm.
    void warmPartIsReadTooLarge() {
        Project warm = fixtures::plungeOfThree(), wrong = warm;
        warm.material->expansion_um_m_k = 11.5;
        warm.gauge->part_warmer_k = 4;
        QVERIFY(within(readsTooLarge_mm(warm), 0.00138, 1e-12));
        wrong.gauge->error_um = 1.38;
        QVERIFY(within(readsTooLarge_mm(wrong), 0.00138, 1e-15));
        const SimulationResult a = simulate(warm), b = simulate(wrong);
        for (std::size_t i = 0; i < a.sections.size(); ++i) {
            for (std::size_t k = 0; k < a.sections[i].radii_mm.size(); ++k) {
                QVERIFY(within(a.sections[i].radii_mm[k], b.sections[i].radii_mm[k], 1e-12));
            }
        }
    }

    /// A rigid system fed in steps of 5 µm: of an error of 10 µm on the diameter exactly one step.
    void partEndsSmallerByWhatIsReadTooLarge() {
        Project p = fixtures::plunge();
        p.machine->compliance_mm_per_n = std::vector<double>{1e-15};
        const double before = simulate(p).sections.front().diameterDeviationMin_mm;
        for (const double error_um : {10.0, -10.0, 20.0}) {
            p.gauge->error_um = error_um;
            const double after = simulate(p).sections.front().diameterDeviationMin_mm;
            QVERIFY(within(after - before, -error_um / 1000, 1e-9));
        }
    }

    void nothingIsReadWrongToTheBit() {
        for (Project p : {fixtures::plungeOfThree(), fixtures::traverse()}) {
            const SimulationResult before = simulate(p);
            p.material->expansion_um_m_k = 20; // of a part that is not warm
            const SimulationResult after = simulate(p);
            QCOMPARE(after.time_s, before.time_s);
            for (std::size_t i = 0; i < after.sections.size(); ++i) {
                QCOMPARE(after.sections[i].radii_mm, before.sections[i].radii_mm);
            }
        }
    }

    /// Only a spark-out until size is ended by the gauge there.
    void positionControlReadsNothing() {
        Project p = fixtures::plungeOfThree();
        p.gauge->control = Control::position;
        const SimulationResult before = simulate(p);
        p.gauge->error_um = 4;
        const SimulationResult after = simulate(p);
        QCOMPARE(after.time_s, before.time_s);
        QCOMPARE(after.sections.front().radii_mm, before.sections.front().radii_mm);
        p.cycle->stages.back() = fixtures::sparkStage(fixtures::untilSize());
        p.gauge->error_um = -0.8;
        const double early_s = simulate(p).time_s;
        p.gauge->error_um = 0.8;
        QVERIFY(simulate(p).time_s >= early_s);
    }

    /// The stocks for which a cycle fails are those of the other part, half the error away.
    void decidedStocksAreThoseOfAnotherPart() {
        for (Project p : {fixtures::plungeOfThree(), fixtures::traverse()}) {
            p.gauge->error_um = 3.1;
            const double half_mm = 3.1 / 2000;
            const StockRange range = usualPhases(p);
            const PhaseDecision mine = decidePhases(p, range);
            const PhaseDecision others = decidePhases(
                shifted(p, 2 * half_mm), {range.from_mm + half_mm, range.to_mm + half_mm});
            QVERIFY(mine.isDecided && others.isDecided);
            const auto failing = mine.failingRanges(), there = others.failingRanges();
            QCOMPARE(failing.size(), there.size());
            for (std::size_t i = 0; i < failing.size(); ++i) {
                QVERIFY(within(failing[i].from_mm + half_mm, there[i].from_mm, 1e-9));
                QVERIFY(within(failing[i].to_mm + half_mm, there[i].to_mm, 1e-9));
            }
        }
    }

    /// No more than the stock, and the field that is to be changed is named.
    void errorBeyondTheStockIsRefused() {
        Project p = fixtures::plunge();
        p.part->stock_mm = 0.05;
        p.cycle->stages.front().stock_mm = 0.05;
        p.gauge->error_um = 60;
        QVERIFY(samples::holds(validate(p), IssueCode::outOfRange, "/gauge/error_um"));
        p.gauge->error_um = 0;
        p.gauge->part_warmer_k = 180; // 62 µm
        QVERIFY(samples::holds(validate(p), IssueCode::outOfRange, "/gauge/part_warmer_k"));
        p.gauge->part_warmer_k = 100;
        QVERIFY(!hasErrors(validate(p)));
    }

    void wheelIsDrivenNoFasterThanTheMachineDoes() {
        Project p = fixtures::plunge();
        p.machine->limits.wheel_speed_m_s = 35;
        QVERIFY(!hasErrors(validate(p)));
        p.machine->limits.wheel_speed_m_s = 34;
        QVERIFY(samples::holds(validate(p), IssueCode::outOfRange, "/machine/wheel_speed_m_s"));
    }
};

} // namespace sparkout::test_gauge_error

SPARKOUT_TEST(test_gauge_error, TestGaugeError)
#include "test_gauge_error.moc"
