// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_measured.h"

#include "app/cli_io.h"
#include "app/cli_report.h"
#include "core/measured/measured_table.h"
#include "core/measured/number_table.h"
#include "core/measured/stiffness_trial.h"
#include "core/printable.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/units.h"
#include "words/measured_words.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

int printSheet(const Project& project, bool json) {
    const std::array<double, 3> places = stiffnessPlaces_mm(project);
    const double load = stiffnessLoad_n(project);
    if (json) {
        print(stdout, ordered_json{{"places_mm", places}, {"load_n", load}}.dump(2) + '\n');
        return done;
    }
    std::string text =
        "Stiffness trial of headstock and tailstock\n"
        "1. Clamp the part as for grinding, wheel and drives at rest.\n"
        "2. Set an indicator on the bed against the part, opposite to the wheel, at ";
    for (std::size_t i = 0; i < places.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < places.size() ? ", then " : " and ") + fixed(places[i], 0);
    }
    text += " mm from the headstock's end.\n3. At each place load the part radially there by a "
            "dynamometer, once to "
            + fixed(load, 0) + " N and back to " + fixed(load / 2, 0)
            + " N, to take the play out; zero the indicator\n   without load.\n4. Read the "
              "deflection in µm at "
            + fixed(load / 2, 0) + " N and at " + fixed(load, 0)
            + " N, and once more.\n5. Write a table of place [mm], load [N], deflection [µm], a "
              "line each, and run\n   sparkout-cli measured FILE --stiffness TABLE.csv\n6. For the "
              "wheel head repeat all with the indicator on the wheel head: --indicator system\n";
    print(stdout, text);
    return done;
}

StiffnessRequest requestOf(const StiffnessTable& table, const manual::Given& given) {
    StiffnessRequest request;
    request.readings = table.readings;
    std::set<double> places;
    for (const StiffnessReading& reading : table.readings) {
        places.insert(reading.position_mm);
    }
    constexpr std::size_t enoughForWheelHead = 3;
    if (given.text("--indicator") == "system") {
        request.deflection = DeflectionOf::system;
        request.findWheelHead = places.size() >= enoughForWheelHead;
    }
    return request;
}

ordered_json stiffnessJson(const StiffnessTrial& trial, const std::vector<CompliantPoint>& points) {
    ordered_json json = {
        {"status", wordsOf(trial.status).key}, {"stiffness", ordered_json::array()},
        {"residuals_um", trial.residuals_um},  {"rms_um", trial.rms_um},
        {"line", wordsOf(trial.line).key},     {"play_um", trial.play_um},
        {"compliance", ordered_json::array()}};
    for (const FoundStiffness& found : trial.found) {
        ordered_json interval = nullptr;
        if (found.interval95) {
            interval = {found.interval95->low, std::isfinite(found.interval95->high)
                                                   ? ordered_json(found.interval95->high)
                                                   : ordered_json(nullptr)};
        }
        json["stiffness"].push_back(
            {{"unit", wordsOf(found.unit).key}, {"n_um", found.n_um}, {"interval_95", interval}});
    }
    for (const CompliantPoint& point : points) {
        json["compliance"].push_back(
            {{"position_mm", point.position_mm}, {"mm_per_n", point.gamma_mm_n}});
    }
    return json;
}

std::string stiffnessText(const StiffnessTrial& trial, const std::vector<CompliantPoint>& points) {
    std::string text;
    for (const FoundStiffness& found : trial.found) {
        text += std::string(wordsOf(found.unit).text) + ": " + fixed(found.n_um, 2) + " N/µm";
        if (found.interval95) {
            text += " (" + fixed(found.interval95->low, 2) + "…"
                    + (std::isfinite(found.interval95->high) ? fixed(found.interval95->high, 2)
                                                             : std::string("∞"))
                    + ")";
        }
        text += '\n';
    }
    text += "residuals of " + std::to_string(trial.residuals_um.size()) + " readings, RMS "
            + fixed(trial.rms_um, 3) + " µm\n" + wordsOf(trial.line).text;
    for (std::size_t i = 0; i < trial.play_um.size(); ++i) {
        text += std::string(i == 0 ? "; play of the headstock " : ", of the tailstock ")
                + fixed(trial.play_um[i], 2) + " µm";
    }
    text += '\n';
    constexpr double nmPerMm = 1e6;
    for (const CompliantPoint& point : points) {
        text += "γ at " + fixed(point.position_mm, 1)
                + " mm of the ground length: " + fixed(point.gamma_mm_n * nmPerMm, 2) + " nm/N\n";
    }
    return text;
}

} // namespace

int findStiffness(const Project& project, const std::string& name, const manual::Given& given) {
    if (!given.has("--stiffness")) {
        return printSheet(project, given.has("--json"));
    }
    const auto text = readOrSay(given.text("--stiffness"), limits::measuredBytes);
    if (!text) {
        return refused;
    }
    const StiffnessTable table = readStiffnessTable(*text);
    if (!table.faults.empty()) {
        printFaults(given.text("--stiffness"), table.faults);
        return refused;
    }
    const StiffnessTrial trial = stiffnessFromTrial(project, requestOf(table, given));
    if (trial.status != StiffnessTrialStatus::found) {
        std::string units;
        for (const StiffnessUnit unit : trial.negative) {
            units += (units.empty() ? ": " : ", ") + std::string(wordsOf(unit).text);
        }
        print(stderr, printable(name) + ": " + wordsOf(trial.status).text + units + '\n');
        return refused;
    }
    // The whole γ is unknown without the wheel head's stiffness.
    std::vector<CompliantPoint> points;
    if (project.machine->stiffness_n_um) {
        points = compliantPoints(
            withStiffness(project, trial, given.text("--stiffness"), {}, table.readings.size()));
    }
    print(stdout, given.has("--json") ? stiffnessJson(trial, points).dump(2) + '\n'
                                      : stiffnessText(trial, points));
    return done;
}

} // namespace sparkout::cli
