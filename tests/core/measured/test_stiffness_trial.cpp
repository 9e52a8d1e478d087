// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness of the units from loads and deflections: the truth from exact readings, intervals that
// cover it with noise, and a refusal of readings that no shaft can give.
#include "core/measured/stiffness_trial.h"
#include "tests/whole_project.h"

#include "core/process/system_compliance.h"
#include "core/project/validate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "tests/check_line.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>

namespace sparkout::test_stiffness_trial {

Project onCentres() {
    Project project = samples::project("stiffness-traverse");
    project.part->shaft.steady_rests.clear();
    project.part->shaft.mounting = Mounting::centres;
    return project;
}

double shaftLength(const Project& project) {
    double length = 0;
    for (const ShaftSegment& segment : project.part->shaft.segments) {
        length += segment.length_mm;
    }
    return length;
}

/// What an indicator would show of a machine with these stiffnesses, by the model's own γ(x).
std::vector<StiffnessReading> readings(Project truth, const Stiffness& stiffness,
                                       DeflectionOf deflection, const std::vector<double>& shares,
                                       double noise_um = 0, std::uint32_t seed = 1) {
    truth.machine->stiffness_n_um = stiffness;
    truth.machine->compliance_mm_per_n = std::monostate();
    constexpr int places = 1001;
    const std::vector<CompliantPlace> along = complianceAlong(truth, places);
    std::vector<StiffnessReading> list;
    std::uint64_t count = 0;
    for (const double share : shares) {
        const ComplianceParts& parts =
            along[static_cast<std::size_t>(std::lround(share * (places - 1)))].parts;
        double gamma = parts.headstock + parts.tailstock + parts.bending;
        gamma += deflection == DeflectionOf::system ? parts.wheelHead : 0;
        for (const double load_n : {100.0, 200.0}) {
            const double z =
                noise_um > 0
                    ? normalQuantile(openUnit(randomBits(seed, RandomStream::plain, count++, 3)))
                    : 0;
            list.push_back(
                {share * shaftLength(truth), load_n, gamma * load_n * 1000 + noise_um * z});
        }
    }
    return list;
}

const FoundStiffness* find(const StiffnessTrial& trial, StiffnessUnit unit) {
    const auto found = std::ranges::find(trial.found, unit, &FoundStiffness::unit);
    return found == trial.found.end() ? nullptr : &*found;
}

bool near(const StiffnessTrial& trial, StiffnessUnit unit, double truth) {
    const FoundStiffness* const found = find(trial, unit);
    return found && std::abs(found->n_um / truth - 1) < 1e-9;
}

class TestStiffnessTrial : public QObject {
    Q_OBJECT

private slots:
    void twoPlacesOfThePartGiveHeadAndTail() {
        const Project project = onCentres();
        const Stiffness truth{35, 22, 80};
        const StiffnessTrial trial = stiffnessFromTrial(
            project, {readings(project, truth, DeflectionOf::part, {0.2, 0.8}), {}, false});
        QVERIFY(trial.status == StiffnessTrialStatus::found);
        QVERIFY(near(trial, StiffnessUnit::headstock, 35));
        QVERIFY(near(trial, StiffnessUnit::tailstock, 22));
        QVERIFY(!find(trial, StiffnessUnit::wheel_head));
        QVERIFY(trial.rms_um < 1e-9);
        QCOMPARE(trial.residuals_um.size(), std::size_t{4});
    }

    void threePlacesOfTheSystemGiveTheWheelHeadToo() {
        Project project = onCentres();
        const Stiffness truth{35, 22, 80};
        const StiffnessRequest request{
            readings(project, truth, DeflectionOf::system, {0.1, 0.5, 0.9}), DeflectionOf::system,
            true};
        const StiffnessTrial trial = stiffnessFromTrial(project, request);
        QVERIFY(trial.status == StiffnessTrialStatus::found);
        QVERIFY(near(trial, StiffnessUnit::headstock, 35));
        QVERIFY(near(trial, StiffnessUnit::tailstock, 22));
        QVERIFY(near(trial, StiffnessUnit::wheel_head, 80));
        // With the wheel head of the project the others follow from two places.
        project.machine->stiffness_n_um->wheel_head = 80;
        const StiffnessTrial two = stiffnessFromTrial(
            project,
            {readings(project, truth, DeflectionOf::system, {0.1, 0.9}), DeflectionOf::system, {}});
        QVERIFY(near(two, StiffnessUnit::headstock, 35) && near(two, StiffnessUnit::tailstock, 22));
    }

    void theCalibratedProjectHasTheMeasuredCompliance() {
        const Project project = onCentres();
        const Stiffness truth{35, 22, 80};
        const auto list = readings(project, truth, DeflectionOf::system, {0.1, 0.5, 0.9});
        const StiffnessTrial trial =
            stiffnessFromTrial(project, {list, DeflectionOf::system, true});
        const Project found = withStiffness(project, trial, "trial.csv", "2026-11-26", list.size());
        QVERIFY2(!hasErrors(validate(found)), samples::listed(validate(found)).c_str());
        for (const StiffnessReading& reading : list) {
            for (const CompliantPlace& place : complianceAlong(found, 1001)) {
                const double x = place.position_mm + found.part->shaft.ground_from_mm;
                if (std::abs(x - reading.position_mm) < 1e-6) {
                    const ComplianceParts& p = place.parts;
                    const double gamma = p.wheelHead + p.headstock + p.tailstock + p.bending;
                    QVERIFY(std::abs(gamma * reading.load_n * 1000 / reading.deflection_um - 1)
                            < 1e-9);
                }
            }
        }
        QCOMPARE(found.measured->calibrations.size(), std::size_t{3});
        QCOMPARE(found.measured->calibrations.front().input,
                 std::string("/machine/stiffness_n_um/headstock"));
    }

    /// Of trials with noise so many intervals hold the truth as 95 % mean (99.9 % of such counts).
    void intervalsCoverTheTruth() {
        const Project project = onCentres();
        const Stiffness truth{35, 22, 80};
        const int repeats = samples::sized(400, 100, 4000);
        int covered = 0;
        for (int i = 0; i < repeats; ++i) {
            const StiffnessTrial trial = stiffnessFromTrial(
                project, {readings(project, truth, DeflectionOf::part, {0.1, 0.5, 0.9}, 0.3,
                                   static_cast<std::uint32_t>(i + 1)),
                          {},
                          false});
            QVERIFY(trial.status == StiffnessTrialStatus::found);
            const FoundStiffness& head = *find(trial, StiffnessUnit::headstock);
            covered += head.interval95->low <= 35 && head.interval95->high >= 35 ? 1 : 0;
        }
        const double expected = 0.95 * repeats, allowed = 3.3 * std::sqrt(0.0475 * repeats);
        QVERIFY2(std::abs(covered - expected) < allowed, QByteArray::number(covered).constData());
    }

    /// Three micrometres of play at the headstock: the stiffness beyond it is the true one, where a
    /// line through zero has half of it.
    void playIsKeptApart() {
        const Project project = onCentres();
        auto list = readings(project, {35, 22, 80}, DeflectionOf::part, {0.1, 0.5, 0.9}, 0.05);
        QVERIFY(stiffnessFromTrial(project, {list, {}, false}).line == LoadLine::straight);
        for (StiffnessReading& reading : list) {
            reading.deflection_um += 3 * (1 - reading.position_mm / shaftLength(project));
        }
        const StiffnessTrial trial = stiffnessFromTrial(project, {list, {}, false});
        QVERIFY(trial.line == LoadLine::play);
        const FoundStiffness& head = *find(trial, StiffnessUnit::headstock);
        QVERIFY(head.interval95->low < 35 && head.interval95->high > 35
                && std::abs(head.n_um / 35 - 1) < 0.1);
        QVERIFY(std::abs(trial.play_um[0] - 3) < 0.3 && std::abs(trial.play_um[1]) < 0.3);
        // At one load it looks like a softer headstock, and that is said.
        std::erase_if(list, [](const StiffnessReading& one) { return one.load_n > 150; });
        const StiffnessTrial once = stiffnessFromTrial(project, {list, {}, false});
        QVERIFY(once.line == LoadLine::untested && once.play_um.empty());
        QVERIFY(find(once, StiffnessUnit::headstock)->n_um < 20);
    }

    /// A joint that stiffens under load, as contacts do, bends the line; chance says so, or that
    /// there is play, in about 1 % of straight trials each.
    void aBentLineIsNamed() {
        const Project project = onCentres();
        auto list = readings(project, {35, 22, 80}, DeflectionOf::part, {0.1, 0.5, 0.9}, 0.05);
        const auto heavier = readings(project, {35, 22, 80}, DeflectionOf::part, {0.1, 0.5, 0.9});
        for (StiffnessReading reading : heavier) { // two loads alone do not bend a line
            reading.load_n *= 4;
            reading.deflection_um *= 4;
            list.push_back(reading);
        }
        for (StiffnessReading& reading : list) {
            const double u = reading.position_mm / shaftLength(project);
            reading.deflection_um -= 1e-5 * (1 - u) * (1 - u) * std::pow(reading.load_n, 2);
        }
        QVERIFY(stiffnessFromTrial(project, {list, {}, false}).line == LoadLine::bent);
        const int repeats = samples::sized(1000, 300, 10'000);
        int named = 0;
        for (int i = 0; i < repeats; ++i) {
            named += stiffnessFromTrial(
                         project, {readings(project, {35, 22, 80}, DeflectionOf::part,
                                            {0.1, 0.5, 0.9}, 0.3, static_cast<std::uint32_t>(i)),
                                   {},
                                   false})
                         .line
                     != LoadLine::straight;
        }
        QVERIFY2(named <= 0.02 * repeats + 3.3 * std::sqrt(0.02 * repeats),
                 QByteArray::number(named).constData());
    }

    void readingsThatNoShaftGivesAreRefused() {
        const Project project = onCentres();
        auto list = readings(project, {35, 22, 80}, DeflectionOf::part, {0.2, 0.8});
        for (StiffnessReading& reading : list) {
            reading.deflection_um *= reading.position_mm > shaftLength(project) / 2 ? -0.2 : 1;
        }
        const StiffnessTrial trial = stiffnessFromTrial(project, {list, {}, false});
        QVERIFY(trial.status == StiffnessTrialStatus::negative);
        QVERIFY(trial.negative == std::vector<StiffnessUnit>{StiffnessUnit::tailstock});
        const Project same = withStiffness(project, trial, {}, {}, 4);
        QCOMPARE(same.machine->stiffness_n_um->headstock,
                 project.machine->stiffness_n_um->headstock);
    }

    void whatCannotBeFoundSaysSo() {
        const Project project = onCentres();
        const auto one = readings(project, {35, 22, 80}, DeflectionOf::part, {0.5});
        QVERIFY(stiffnessFromTrial(project, {one, {}, false}).status
                == StiffnessTrialStatus::tooFewPlaces);
        const auto two = readings(project, {35, 22, 80}, DeflectionOf::system, {0.2, 0.8});
        QVERIFY(stiffnessFromTrial(project, {two, DeflectionOf::system, true}).status
                == StiffnessTrialStatus::tooFewPlaces);
        Project rested = project;
        rested.part->shaft.steady_rests.push_back({100, 50});
        QVERIFY(stiffnessFromTrial(rested, {two, {}, false}).status
                == StiffnessTrialStatus::notMeasurable);
        auto beyond = two;
        beyond.front().position_mm = 2 * shaftLength(project);
        QVERIFY(stiffnessFromTrial(project, {beyond, {}, false}).status
                == StiffnessTrialStatus::notMeasurable);
    }

    void inAChuckTheHeadAlone() {
        Project project = onCentres();
        project.part->shaft.mounting = Mounting::chuck;
        const Stiffness truth{35, 22, 80};
        const StiffnessTrial trial = stiffnessFromTrial(
            project, {readings(project, truth, DeflectionOf::part, {0.3, 0.6}), {}, false});
        QVERIFY(near(trial, StiffnessUnit::headstock, 35));
        QCOMPARE(trial.found.size(), std::size_t{1});
    }

    void theSheetsPlacesAndLoad() {
        const Project project = onCentres();
        const auto places = stiffnessPlaces_mm(project);
        QVERIFY(places[0] > 0 && places[1] > places[0] && places[2] > places[1]
                && places[2] < shaftLength(project));
        QVERIFY(stiffnessLoad_n(project) >= 50);
    }
};

} // namespace sparkout::test_stiffness_trial

SPARKOUT_TEST(test_stiffness_trial, TestStiffnessTrial)
#include "test_stiffness_trial.moc"
