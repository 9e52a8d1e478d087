// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_measured.h"

#include "app/cli_io.h"
#include "app/cli_report.h"
#include "core/file/output_json.h"
#include "core/measured/measured_table.h"
#include "core/measured/number_table.h"
#include "core/printable.h"
#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "core/simulation/simulate.h"
#include "core/surface/roundness_readings.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

ordered_json deviationJson(const std::optional<RoundnessZone>& zone) {
    return zone ? ordered_json(zone->deviation() * units::umPerMm) : ordered_json(nullptr);
}

ordered_json readingsJson(const std::vector<double>& radii_mm) {
    ordered_json list = ordered_json::array();
    for (const RoundnessReading& reading : roundnessReadings(radii_mm)) {
        list.push_back({{"filter_upr", jsonOrNull(reading.cutoff_upr)},
                        {"mzc_um", deviationJson(reading.minimumZone)},
                        {"lsc_um", deviationJson(reading.leastSquares)},
                        {"mic_um", deviationJson(reading.inscribed)},
                        {"mcc_um", deviationJson(reading.circumscribed)}});
    }
    return list;
}

std::string deviationText(const char* circle, const std::optional<RoundnessZone>& zone) {
    return std::string(circle) + ' '
           + (zone ? fixed(zone->deviation() * units::umPerMm, 3) : std::string("–"));
}

std::string readingsText(const std::string& where, const std::vector<double>& radii_mm) {
    std::string text =
        where + ": RONt in µm, " + std::to_string(radii_mm.size()) + " radii, which resolve up to "
        + std::to_string(resolvedUndulations(radii_mm.size())) + " undulations per revolution\n";
    for (const RoundnessReading& reading : roundnessReadings(radii_mm)) {
        text += reading.cutoff_upr
                    ? "  Gaussian filter " + std::to_string(*reading.cutoff_upr) + " UPR: "
                    : std::string("  not filtered: ");
        text += deviationText("MZC", reading.minimumZone) + ", "
                + deviationText("LSC", reading.leastSquares) + ", "
                + deviationText("MIC", reading.inscribed) + ", "
                + deviationText("MCC", reading.circumscribed) + '\n';
    }
    return text;
}

/// The recorded profile; if it cannot be read, reports it and returns an empty value.
std::optional<ClosedProfile> readProfile(const Project& project, const std::string& file) {
    const auto text = readOrSay(file, limits::measuredBytes);
    if (!text) {
        return std::nullopt;
    }
    ClosedProfile profile = readClosedProfile(*text, project.part->diameter_mm / 2);
    printFaults(file, profile.faults);
    return profile.faults.empty() ? std::optional(std::move(profile)) : std::nullopt;
}

} // namespace

int stateRoundness(const Project& project, const std::string& name, const manual::Given& given) {
    std::optional<ClosedProfile> recorded;
    if (given.has("--profile")) {
        recorded = readProfile(project, given.text("--profile"));
        if (!recorded) {
            return refused;
        }
    }
    const SimulationResult result = simulateUnchecked(project);
    if (result.status != RunStatus::completed) {
        print(stderr, printable(name) + ": " + statusSentence(result) + '\n');
        return cannotReachSize;
    }
    ordered_json json = {{"roundness", ordered_json::array()}, {"recorded", nullptr}};
    std::string text;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const std::vector<double>& radii = result.sections[i].radii_mm;
        const Zone zone = project.operation->travels ? static_cast<Zone>(i) : Zone::section;
        const int section = static_cast<int>(i);
        json["roundness"].push_back({{"where", sectionName(zone, section)},
                                     {"radii", radii.size()},
                                     {"resolved_upr", resolvedUndulations(radii.size())},
                                     {"readings", readingsJson(radii)}});
        text += readingsText(sectionName(zone, section, First::inTexts), radii);
    }
    if (recorded) {
        json["recorded"] = {{"points", recorded->rows},
                            {"resolved_upr", resolvedUndulations(recorded->radii_mm.size())},
                            {"readings", readingsJson(recorded->radii_mm)}};
        text += readingsText("recorded", recorded->radii_mm);
    }
    print(stdout, given.has("--json") ? json.dump(2) + '\n' : text);
    return done;
}

} // namespace sparkout::cli
