// SPDX-License-Identifier: GPL-3.0-or-later
// The form that the machine prints onto every part: what its harmonics make of roundness, runout
// and diameters, radii and reading of a run with it, lobes of a number not known, batches, bounds
// of the search, and what is said where nothing is given.
#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"
#include "core/process/printed_form.h"
#include "core/project/measured.h"
#include "core/project/validate.h"
#include "core/quality/result_json.h"
#include "core/search/limit.h"
#include "core/study/measured_form.h"
#include "core/study/operation.h"
#include "core/surface/roundness.h"
#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

namespace sparkout::test_machine_form {

using namespace search_checks;
using fixtures::within;
using std::numbers::pi;

const std::vector<double> roundness_um{1.70, 3.71, 2.68}, runout_um{2.24, 4.85, 3.67};

Project shaft() {
    return samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
}

Project withForm(Project p, std::optional<int> lobes) {
    p.machine->geometric_runout_um = 0;
    p.machine->form = MachineForm{roundness_um, runout_um, lobes, {}};
    return p;
}

/// The same passes whatever the gauge would read.
Project byPosition(Project p) {
    p.gauge->control = Control::position;
    return p;
}

double runoutOf(const std::vector<double>& radii) {
    const auto [least, most] = std::ranges::minmax(radii);
    return most - least;
}

/// Of a perfect circle with the form on it [mm].
std::vector<double> printedOnCircle(const PrintedForm& form, int radii, double radius_mm) {
    std::vector<double> found;
    for (int k = 0; k < radii; ++k) {
        found.push_back(radius_mm - form.at_mm(2 * pi * k / radii));
    }
    return found;
}

double roundnessOf_mm(const std::vector<double>& radii) {
    return minimumZoneCircles(radii, Directions(radii.size())).deviation();
}

/// max c − min c over many angles, by its definition.
double plainRunout_mm(double a1, double aj, int j, double at) {
    double least = 1, most = -1;
    constexpr int angles = 3600;
    for (int i = 0; i < angles; ++i) {
        const double angle = 2 * pi * i / angles;
        const double c = a1 * std::cos(angle - at) + aj * std::cos(j * angle);
        least = std::min(least, c);
        most = std::max(most, c);
    }
    return most - least;
}

std::set<std::string> refusedPaths(const Project& p) {
    std::set<std::string> paths;
    for (const Issue& issue : validate(p)) {
        if (issue.severity == Severity::error) {
            paths.insert(issue.path);
        }
    }
    return paths;
}

class TestMachineForm : public QObject {
    Q_OBJECT

private slots:
    void eccentricityIsRunoutAndNoDeviationFromRoundness() {
        const PrintedForm form{.eccentricity_mm = 2e-3, .lobes = 3, .at = 0.4};
        const std::vector<double> radii = printedOnCircle(form, 360, 15);
        QVERIFY(within(runoutOf(radii), 4e-3, 1e-6));
        QVERIFY(roundnessOf_mm(radii) < 1e-6); // e²/R
        QVERIFY(within(printedRunout_mm(form), 4e-3, 1e-15));
    }

    void loneLobesAreRoundnessAndRunoutAlike() {
        for (int j = 2; j <= 7; ++j) {
            const PrintedForm form{.lobe_mm = 1.5e-3, .lobes = j};
            const std::vector<double> radii = printedOnCircle(form, radiiOfLobe * j, 15);
            QVERIFY(within(runoutOf(radii), 3e-3, 1e-12));
            QVERIFY(within(roundnessOf_mm(radii), 3e-3, 1e-7));
            QVERIFY(within(printedRunout_mm(form), 3e-3, 1e-9));
        }
    }

    void evenLobesChangeDiametersAndOddOnesDoNot() {
        for (int j = 2; j <= 7; ++j) {
            const PrintedForm form{.eccentricity_mm = 1e-3, .lobe_mm = 1.5e-3, .lobes = j, .at = 1};
            const int K = 2 * radiiOfLobe * j; // even, with a lobe's top and bottom among them
            const std::vector<double> radii = printedOnCircle(form, K, 15);
            double least = 100, most = 0;
            for (int k = 0; k < K / 2; ++k) {
                const auto i = static_cast<std::size_t>(k), half = static_cast<std::size_t>(K / 2);
                const double diameter = radii[i] + radii[i + half];
                least = std::min(least, diameter);
                most = std::max(most, diameter);
            }
            const double height = j % 2 == 0 ? 3e-3 : 0;
            QVERIFY(within(least, 30 - height, 1e-12) && within(most, 30 + height, 1e-12));
        }
    }

    void formsAddUp() {
        const PrintedForm both{.eccentricity_mm = 1e-3, .lobe_mm = 2e-3, .lobes = 5, .at = 0.7};
        PrintedForm one = both, other = both;
        one.lobe_mm = 0;
        other.eccentricity_mm = 0;
        for (int k = 0; k < 100; ++k) {
            QVERIFY(within(both.at_mm(k), one.at_mm(k) + other.at_mm(k), 1e-15));
        }
        QVERIFY(printedRunout_mm(both) <= both.most_mm());
        QVERIFY(printedRunout_mm(both) >= std::max(2 * both.lobe_mm, 2 * both.eccentricity_mm));
    }

    // Thesis table 2: the amplitudes of НЗ that make 3.71 and 4.85 µm.
    void harmonicsOfTheTableAreFound() {
        for (const auto& [lobes, a1_um] : {std::pair(2, 0.86), std::pair(3, 0.68)}) {
            const PrintedForm form = printedForm(withForm(shaft(), lobes), 1);
            QVERIFY(within(form.lobe_mm, 1.855e-3, 1e-12) && form.lobes == lobes);
            QVERIFY2(within(form.eccentricity_mm * 1e3, a1_um, 0.01),
                     qPrintable(QString::number(form.eccentricity_mm * 1e3)));
        }
    }

    // The mean over all directions is the runout given, and one part shows it.
    void runoutIsTheMeanOverAllDirections() {
        for (const int lobes : {2, 3, 4, 5, 9}) {
            for (std::size_t zone = 0; zone < 3; ++zone) {
                const PrintedForm form = printedForm(withForm(shaft(), lobes), zone);
                double sum = 0;
                constexpr int directions = 200;
                for (int i = 0; i < directions; ++i) {
                    sum += plainRunout_mm(form.eccentricity_mm, form.lobe_mm, lobes,
                                          2 * pi * (i + 0.3) / directions);
                }
                QVERIFY(within(1e3 * sum / directions, runout_um[zone], 0.003));
                QVERIFY(
                    within(1e3 * plainRunout_mm(form.eccentricity_mm, form.lobe_mm, lobes, form.at),
                           runout_um[zone], 0.002));
            }
        }
    }

    void directionGivenIsKept() {
        Project p = withForm(shaft(), 2);
        p.machine->form->runout_at_deg = 90;
        const PrintedForm form = printedForm(p, 1);
        const PrintedForm free = printedForm(withForm(shaft(), 2), 1);
        QVERIFY(within(form.at, pi / 2, 1e-12));
        QVERIFY(form.eccentricity_mm == free.eccentricity_mm && form.at != free.at);
    }

    void onlyWhatIsGivenIsPrinted() {
        Project p = withForm(shaft(), 2);
        p.machine->form->roundness_um.reset();
        QVERIFY(printedForm(p, 1).lobe_mm == 0);
        QVERIFY(within(printedForm(p, 1).eccentricity_mm, 4.85e-3 / 2, 1e-15));
        p = withForm(shaft(), 2);
        p.machine->form->runout_um.reset();
        QVERIFY(printedForm(p, 1).eccentricity_mm == 0 && printedForm(p, 1).lobe_mm > 0);
        QVERIFY(isRoundnessKnown(*p.machine) && !isRunoutKnown(*p.machine));
        p.machine->form = MachineForm{};
        QVERIFY(printedDepths(p, 1).empty());
    }

    void nothingPrintedIsThePlainRunBitByBit() {
        for (const char* name : {"resources/examples/shaft-30h6-factory.sparkout",
                                 "resources/examples/internal-plunge.sparkout"}) {
            Project plain = samples::projectIn(name);
            plain.machine->geometric_runout_um = 0;
            Project zero = plain;
            const auto places = static_cast<std::size_t>(placeCount(plain));
            zero.machine->form = MachineForm{
                std::vector<double>(places, 0.0), std::vector<double>(places, 0.0), 2, {}};
            const SimulationResult a = simulate(plain), b = simulate(zero);
            QVERIFY(a.status == RunStatus::completed && a.time_s == b.time_s);
            for (std::size_t i = 0; i < a.sections.size(); ++i) {
                QVERIFY(a.sections[i].radii_mm == b.sections[i].radii_mm);
                QVERIFY(a.sections[i].radialRunout_mm == b.sections[i].radialRunout_mm);
            }
        }
    }

    // R_k − c of a shaft, R_k + c of a bore, in the trajectory too.
    void theRadiiAreThoseOfTheMachinesFrameLessTheForm() {
        for (const char* name : {"resources/examples/shaft-30h6-factory.sparkout",
                                 "resources/examples/internal-plunge.sparkout",
                                 "resources/examples/plunge-shaft-two-stage.sparkout"}) {
            Project plain = byPosition(samples::projectIn(name));
            plain.machine->geometric_runout_um = 0;
            Project printed = plain;
            std::vector<double> round, out;
            for (int place = 0; place < placeCount(plain); ++place) {
                round.push_back(1 + place);
                out.push_back(3 + place);
            }
            printed.machine->form = MachineForm{round, out, 2, {}};
            Trajectory trajectory;
            const SimulationResult a = simulate(plain), b = simulate(printed, &trajectory);
            QVERIFY(a.status == RunStatus::completed && b.status == a.status);
            const double side = plain.part->surface == Surface::external ? -1 : 1;
            for (std::size_t i = 0; i < a.sections.size(); ++i) {
                const PrintedForm form = printedForm(printed, i);
                const auto K = static_cast<double>(trajectory.radii);
                for (std::size_t k = 0; k < a.sections[i].radii_mm.size(); ++k) {
                    const double c = form.at_mm(2 * pi * static_cast<double>(k) / K);
                    QVERIFY(within(b.sections[i].radii_mm[k], a.sections[i].radii_mm[k] + side * c,
                                   1e-12));
                }
                QVERIFY(
                    within(b.sections[i].radialRunout_mm, runoutOf(b.sections[i].radii_mm), 1e-15));
            }
            const Pass& last = trajectory.passes.back();
            const std::size_t place = static_cast<std::size_t>(
                plain.operation->travels ? static_cast<int>(last.place.zone) : last.place.section);
            for (std::size_t k = 0; k < b.sections[place].radii_mm.size(); ++k) {
                QVERIFY(trajectory.visits[last.firstVisit + k].radius_mm
                        == b.sections[place].radii_mm[k]);
            }
        }
    }

    // An oval is read at its narrowest, so that the cycle ends before the mean is at size.
    void theGaugeReadsThePrintedPart() {
        const SimulationResult plain = simulate(shaft());
        for (const int lobes : {2, 3}) {
            const SimulationResult result = simulate(withForm(shaft(), lobes));
            const SectionResult& nz = result.sections[1];
            QVERIFY(within(result.gaugeReading_mm, 30 + nz.diameterDeviationMin_mm, 1e-12));
            const double spread = nz.diameterDeviationMax_mm - nz.diameterDeviationMin_mm;
            if (lobes == 2) {
                QVERIFY(within(spread, 7.42e-3, 2e-4));
                QVERIFY(result.time_s < plain.time_s);
            } else {
                QVERIFY(spread < 2e-4 && result.time_s == plain.time_s);
            }
        }
    }

    // As calibrated: three numbers of roundness and three of runout give six amplitudes.
    void tableTwosFormByZoneComesOut() {
        for (const int lobes : {2, 3}) {
            const SimulationResult result = simulate(withForm(shaft(), lobes));
            const PartAccuracy accuracy = accuracyOf(result);
            for (std::size_t zone = 0; zone < 3; ++zone) {
                const double round = 1e3 * accuracy.sections[zone].minimumZone.deviation();
                const double out = 1e3 * result.sections[zone].radialRunout_mm;
                std::printf("%d lobes, zone %d: roundness %.2f, runout %.2f\n", lobes,
                            static_cast<int>(zone), round, out);
                QVERIFY(within(round, roundness_um[zone], 0.06));
                QVERIFY(within(out, runout_um[zone], 0.08));
            }
        }
    }

    void geometricRunoutIsNotUsedBesideAForm() {
        Project p = withForm(shaft(), 3);
        const SimulationResult without = simulate(p);
        p.machine->geometric_runout_um = 5;
        QVERIFY(simulate(p).sections[1].radialRunout_mm == without.sections[1].radialRunout_mm);
        const Project plain = shaft();
        QVERIFY(addedRunout_um(*p.machine) == 0 && addedRunout_um(*plain.machine) == 1);
    }

    // Three lobes are run; the diameters with two stand beside.
    void lobesOfANumberNotKnownStandBothWays() {
        const Project p = withForm(shaft(), {});
        const SimulationResult odd = simulate(withForm(shaft(), 3));
        const SimulationResult even = simulate(withForm(shaft(), 2));
        const SimulationResult result = simulate(p);
        QVERIFY(odd.ifEven.empty() && even.ifEven.empty() && result.ifEven.size() == 3);
        for (std::size_t zone = 0; zone < 3; ++zone) {
            QVERIFY(result.sections[zone].radii_mm == odd.sections[zone].radii_mm);
            QVERIFY(result.ifEven[zone].least_mm == even.sections[zone].diameterDeviationMin_mm);
            QVERIFY(result.ifEven[zone].most_mm == even.sections[zone].diameterDeviationMax_mm);
        }
        const Issues issues = validate(p);
        const auto warned = std::ranges::find(issues, IssueCode::lobesUnknown, &Issue::code);
        QVERIFY(warned != issues.end() && warned->severity == Severity::warning);
        QVERIFY(within(std::get<Amount>(warned->value).number, 7.42, 1e-12));
        QVERIFY(std::get<Amount>(warned->limit).number == 16);
        const Issues known = validate(withForm(shaft(), 2));
        QVERIFY(std::ranges::find(known, IssueCode::lobesUnknown, &Issue::code) == known.end());
        const auto json = nlohmann::json::parse(resultJson(result, evaluateConstraints(result)));
        const auto& stated = json["zones"]["nz"]["diameter_deviation_even_lobes_um"];
        QVERIFY(within(stated[0].get<double>(), 1e3 * result.ifEven[1].least_mm, 1e-9));
    }

    void whatIsNotGivenIsSaidNotToBeKnown() {
        const auto known = [](const Project& p) {
            const SimulationResult result = simulate(p);
            const auto json =
                nlohmann::json::parse(resultJson(result, evaluateConstraints(result)));
            const auto& zone = json["zones"]["nz"]["machine_known"];
            for (const auto& constraint : json["constraints"]) {
                const std::string name = constraint["name"];
                const bool isForm = name == "roundness" || name == "radial_runout"
                                    || name == "cylindricity" || name == "total_runout";
                if (isForm != constraint.contains("machine_known")) {
                    return std::pair(-1, -1);
                }
            }
            return std::pair<int, int>(zone["roundness"].get<bool>(),
                                       zone["radial_runout"].get<bool>());
        };
        Project p = shaft();
        QVERIFY(known(p) == std::pair(0, 1)); // its geometric runout is 1 µm
        p.machine->geometric_runout_um = 0;
        QVERIFY(known(p) == std::pair(0, 0));
        QVERIFY(known(withForm(p, 2)) == std::pair(1, 1));
    }

    void wrongFormsAreRefused() {
        Project p = withForm(shaft(), 2);
        QVERIFY(refusedPaths(p).empty());
        p.machine->form->runout_um = {{2.24, 3.5, 3.67}}; // below 3.71
        QVERIFY(refusedPaths(p) == std::set<std::string>{"/machine/form/runout_um/1"});
        p = withForm(shaft(), 2);
        p.machine->form->roundness_um = {{1, 2}};
        QVERIFY(refusedPaths(p) == std::set<std::string>{"/machine/form/roundness_um"});
        p.machine->form->roundness_um = {{1, -2, 1}};
        QVERIFY(refusedPaths(p) == std::set<std::string>{"/machine/form/roundness_um/1"});
        p = withForm(shaft(), 1);
        QVERIFY(refusedPaths(p) == std::set<std::string>{"/machine/form/lobes"});
        p = withForm(shaft(), 4); // 36 radii
        QVERIFY(refusedPaths(p) == std::set<std::string>{"/part/radii_per_section"});
        p.part->radii_per_section = 48;
        QVERIFY(refusedPaths(p).empty());
    }

    void anotherKindOfGrindingForgetsTheZones() {
        const Project p = withForm(shaft(), 2);
        const Project plunge = withOperation(p, Operation::plunge);
        QVERIFY(plunge.machine->form && plunge.machine->form->lobes == 2);
        QVERIFY(!plunge.machine->form->roundness_um && !plunge.machine->form->runout_um);
        const Project back = withOperation(plunge, Operation::traverse, &p);
        QVERIFY(back.machine->form->roundness_um == p.machine->form->roundness_um);
    }

    void measuredPartsOfferTheirMeans() {
        Project p = shaft();
        p.measured.emplace();
        QVERIFY(!measuredForm(p));
        for (int place = 0; place < 3; ++place) {
            for (const double more_um : {-0.4, 0.4}) {
                const auto i = static_cast<std::size_t>(place);
                MeasuredPart part;
                part.place = place;
                part.roundness_um = roundness_um[i] + more_um;
                p.measured->parts.push_back(part);
            }
        }
        QVERIFY(measuredForm(p)->roundness_um == roundness_um && !measuredForm(p)->runout_um);
        for (int place = 0; place < 3; ++place) { // of РЗ2 below its roundness
            MeasuredSummary& summary = p.measured->summaries.emplace_back();
            summary.quantity = MeasuredQuantity::radial_runout;
            summary.place = place;
            summary.mean_um = place == 2 ? 2.5 : 5;
        }
        const Project taken = withMeasuredForm(p);
        QVERIFY((taken.machine->form->runout_um == std::vector{5.0, 5.0, 2.68}));
        QVERIFY(!taken.machine->form->lobes && refusedPaths(taken).empty());
        std::erase_if(p.measured->parts, [](const MeasuredPart& part) { return part.place == 0; });
        QVERIFY(!measuredForm(p)->roundness_um);
    }

    // A factor s with mean 1 and deviation σ on 2·A_j: roundness has the mean 2·A_j and the
    // deviation σ·2·A_j; over the whole turn the mean runout is Δ_m.
    void aBatchScattersAsItsFactorsDo() {
        constexpr double sigma = 0.2;
        Project p = withForm(shaft(), 3);
        p.part->tolerance.roundness_um = 20;
        p.batch = Batch{};
        p.batch->parts = 200;
        p.batch->factors.machine_form.emplace().normal = std::vector<double>{1, sigma};
        p.batch->factors.runout_at_deg.emplace().uniform = std::vector<double>{0, 360};
        QVERIFY(checkBatch(p).empty());
        const BatchResult batch = runBatch(p);
        const std::vector<Characteristic> all = characteristicsOf(p);
        int seen = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Requirement* const row = all[i].requirement;
            if (!row || all[i].section != 1) {
                continue;
            }
            const Moments moments = momentsOf(batch.statistics.values[i]);
            if (row->kind == ConstraintKind::roundness) {
                QVERIFY(within(moments.mean, 3.71, 0.06));
                QVERIFY(within(moments.deviation, sigma * 3.71, 0.04));
                ++seen;
            } else if (row->kind == ConstraintKind::radialRunout) {
                QVERIFY(within(moments.mean, 4.85, 0.06));
                QVERIFY(moments.deviation > sigma * 4.85);
                ++seen;
            }
        }
        QVERIFY(seen == 2);
        Project without = p;
        without.machine->form.reset();
        QVERIFY(!checkBatch(without).empty());
    }

    // The bounds of the search hold: the answer is that of running all, and no cycle is quicker
    // than the stepless limit.
    void thePrunedSearchFindsTheFullSearchsCycle() {
        std::mt19937_64 random(31);
        std::uniform_real_distribution<double> share(0, 1);
        int found = 0;
        const unsigned count = searches(80);
        for (unsigned seed = 0; seed < count; ++seed) {
            Project p = smallCase(seed);
            const auto places = static_cast<std::size_t>(placeCount(p));
            const double field_um = p.part->upper_deviation_um - p.part->lower_deviation_um;
            std::vector<double> round(places), out(places);
            for (std::size_t i = 0; i < places; ++i) {
                round[i] = 0.1 * field_um * share(random);
                out[i] = round[i] + 0.1 * field_um * share(random);
            }
            if (p.part->profile != ProfileForm::measured) {
                p.part->radii_per_section = std::max(p.part->radii_per_section, 36);
            }
            p.machine->form = MachineForm{round, out, seed % 3 == 0 ? 3 : 2, {}};
            const SearchSummary full = search(p, SearchMethod::full);
            const SearchSummary pruned = search(p);
            QVERIFY2(same(pruned, full), qPrintable(QString::number(seed)));
            if (full.best) {
                ++found;
                QVERIFY2(steplessLimit_s(p) <= full.best->time_s,
                         qPrintable(QString::number(seed)));
            }
        }
        std::printf("searches of printed forms with a cycle: %d\n", found);
        QVERIFY(found > static_cast<int>(count) / 8);
    }
};

} // namespace sparkout::test_machine_form

SPARKOUT_TEST(test_machine_form, TestMachineForm)
#include "test_machine_form.moc"
