// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_report.h"

#include "app/cli_shop.h"
#include "core/project/strict_json.h"
#include "core/project/validate.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/roughness.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

const char* zoneKey(Zone zone) {
    constexpr std::array keys{"rz1", "nz", "rz2", "section"};
    return keys[static_cast<std::size_t>(zone)];
}

const char* stepKey(Step step) {
    constexpr std::array keys{"", "E1", "E2", "E3", "E4", "E5"};
    return keys[static_cast<std::size_t>(step)];
}

const char* statusKey(RunStatus status) {
    switch (status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize: return "cannot_reach_size";
    case RunStatus::tooLong: return "too_long";
    case RunStatus::stopped: return "stopped";
    case RunStatus::notSolved: return "not_solved";
    }
    return "";
}

bool isTraverse(const SimulationResult& result) {
    return result.project.operation == Operation::traverse;
}

std::string sectionName(Zone zone, int section) {
    return zone == Zone::section ? "section " + std::to_string(section) : zoneKey(zone);
}

const char* formKey(LongitudinalForm form) {
    constexpr std::array keys{"straight", "taper", "barrel", "saddle"};
    return keys[static_cast<std::size_t>(form)];
}

ordered_json zoneJson(const SimulationResult& result, const SectionResult& section,
                      const SectionAccuracy& accuracy) {
    const double nominal = result.project.part.diameter_mm / 2;
    ordered_json radii = ordered_json::array();
    for (const double radius : section.radii_mm) {
        radii.push_back((radius - nominal) * units::umPerMm);
    }
    ordered_json roughness; // null where none is required
    if (section.lastCut) {
        roughness =
            RoughnessModel(result.project).roughness(section.lastCut->depth_mm) * units::umPerMm;
    }
    return {{"diameter_deviation_um",
             {section.diameterDeviationMin_mm * units::umPerMm,
              section.diameterDeviationMax_mm * units::umPerMm}},
            {"radial_runout_um", section.radialRunout_mm * units::umPerMm},
            {"roundness_um", accuracy.minimumZone.deviation() * units::umPerMm},
            {"roundness_least_squares_um", accuracy.leastSquares.deviation() * units::umPerMm},
            {"roughness_ra_um", std::move(roughness)},
            {"peak_normal_force_n", section.peakNormalForce_n},
            {"position_mm", section.position_mm},
            {"compliance_mm_per_n", section.compliance_mm_per_n},
            {"radii_um", std::move(radii)}};
}

std::string whereText(const ConstraintResult& constraint) {
    if (constraint.at) {
        return placeText(*constraint.at);
    }
    switch (scopeOf(constraint.kind)) {
    case ConstraintScope::section: return sectionName(constraint.zone, constraint.section);
    case ConstraintScope::part: return "part";
    case ConstraintScope::pass:
    case ConstraintScope::setting: break;
    }
    return constraint.stage > 0 ? "stage " + std::to_string(constraint.stage) : "cycle";
}

ordered_json constraintJson(const ConstraintResult& constraint) {
    return {{"name", constraintName(constraint.kind)},
            {"unit", constraintUnit(constraint.kind)},
            {"limit", constraint.limit},
            {"value", constraint.value},
            {"margin", constraint.margin},
            {"relative_margin", constraint.relativeMargin},
            {"where", whereText(constraint)},
            {"ok", constraint.holds}};
}

ordered_json partJson(const PartAccuracy& accuracy) {
    return {{"cylindricity_um", accuracy.minimumZone.deviation() * units::umPerMm},
            {"cylindricity_least_squares_um", accuracy.leastSquares.deviation() * units::umPerMm},
            {"total_runout_um", accuracy.totalRunout_mm * units::umPerMm},
            {"taper_um", accuracy.profile.taper_mm * units::umPerMm},
            {"crown_um", accuracy.profile.crown_mm * units::umPerMm},
            {"form", formKey(accuracy.profile.form)}};
}

ordered_json burnJson(const BurnState& burn) {
    return {{"depth_of_cut_um", burn.visit.depth_mm * units::umPerMm},
            {"limit_depth_um", burn.limitDepth_mm * units::umPerMm},
            {"stock_left_um", burn.visit.stock_mm * units::umPerMm},
            {"damaged_depth_um", burn.damagedDepth_mm * units::umPerMm},
            {"rise_at_stock_left_k", burn.rise_k}};
}

ordered_json constraintsJson(const std::vector<ConstraintResult>& constraints) {
    ordered_json list = ordered_json::array();
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        list.push_back(constraintJson(constraint));
    }
    return list;
}

/// The zones as an object, or the sections as a list.
ordered_json sectionsJson(const SimulationResult& result, const PartAccuracy& accuracy) {
    ordered_json all = isTraverse(result) ? ordered_json::object() : ordered_json::array();
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        ordered_json one = zoneJson(result, section, accuracy.sections[i]);
        isTraverse(result) ? void(all[zoneKey(section.zone)] = std::move(one))
                           : all.push_back(std::move(one));
    }
    return all;
}

std::string padded(std::string name) {
    constexpr std::size_t column = 21;
    name.resize(std::max(column, name.size() + 1), ' ');
    return name;
}

std::string um(double value_mm) {
    return fixed(value_mm * units::umPerMm, 3);
}

std::string accuracyText(const SimulationResult& result, const PartAccuracy& accuracy) {
    std::string text = "deviations, µm       min, max of the diameter; radial runout; roundness by "
                       "minimum zone, least squares\n";
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        text += padded("  " + sectionName(section.zone, static_cast<int>(i)))
                + um(section.diameterDeviationMin_mm) + ", " + um(section.diameterDeviationMax_mm)
                + "; " + um(section.radialRunout_mm) + "; "
                + um(accuracy.sections[i].minimumZone.deviation()) + ", "
                + um(accuracy.sections[i].leastSquares.deviation()) + '\n';
    }
    return text + "cylindricity, µm     " + um(accuracy.minimumZone.deviation())
           + " by minimum zone, " + um(accuracy.leastSquares.deviation())
           + " by least squares\ntotal runout, µm     " + um(accuracy.totalRunout_mm)
           + "\nform                 " + formKey(accuracy.profile.form) + "; taper "
           + um(accuracy.profile.taper_mm) + " µm, crown " + um(accuracy.profile.crown_mm)
           + " µm\n";
}

std::string constraintLine(const ConstraintResult& constraint) {
    const std::string unit = constraintUnit(constraint.kind);
    const int decimals = unit.empty() ? 0 : unit == "mm" ? 5 : 3;
    return padded(std::string("  ") + constraintName(constraint.kind))
           + fixed(constraint.value, decimals) + ", " + fixed(constraint.limit, decimals) + ", "
           + fixed(constraint.margin, decimals) + (unit.empty() ? "" : " ") + unit + "  "
           + (constraint.holds ? "holds" : "FAILS") + " in " + whereText(constraint) + '\n';
}

std::string requirementsText(const SimulationResult& result,
                             const std::vector<ConstraintResult>& constraints) {
    std::string text = "requirements         value, limit, margin at its worst place\n";
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        text += constraintLine(constraint);
    }
    if (const auto burn = burnStateOf(result)) {
        text += "nearest to burning   " + um(burn->visit.depth_mm) + " µm cut with "
                + um(burn->visit.stock_mm) + " µm of stock left: damaged "
                + um(burn->damagedDepth_mm) + " µm deep, " + fixed(burn->rise_k, 0)
                + " K hotter at the stock's end\n";
    }
    return text;
}

} // namespace

std::string placeText(const Place& place) {
    const bool plunge = place.zone == Zone::section;
    return sectionName(place.zone, place.section) + (plunge ? "" : " ") + stepKey(place.step)
           + " stage " + std::to_string(place.stage) + (plunge ? " revolution " : " double stroke ")
           + std::to_string(place.cycleCount);
}

std::string fixed(double value, int decimals) {
    char buffer[400]; // the largest double has 309 digits before the point
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0,
                                            std::chars_format::fixed, decimals);
    return {buffer, end};
}

std::string issueLine(const std::string& file, const Issue& issue) {
    std::string line = file + ": ";
    if (!issue.path.empty()) {
        line += issue.path + ": ";
    }
    if (issue.severity == Severity::warning) {
        line += "warning: ";
    }
    line += fillTemplate(issueTemplate(issue.code), issue);
    return printable(line); // one line a fault, whatever a key or a file name may hold
}

std::string resultJson(const SimulationResult& result,
                       const std::vector<ConstraintResult>& constraints) {
    ordered_json root;
    root["status"] = statusKey(result.status);
    root["operation"] = isTraverse(result) ? "traverse" : "plunge";
    root["engine_version"] = result.engineVersion;
    root["cycle_time_min"] = result.time_s / units::secondsPerMinute;
    root[isTraverse(result) ? "double_strokes" : "revolutions"] = result.cycleCount;
    root[isTraverse(result) ? "double_strokes_by_stage" : "revolutions_by_stage"] =
        result.countsByStage;
    ordered_json stageTimes = ordered_json::array();
    for (const double time_s : result.timeByStage_s) {
        stageTimes.push_back(time_s / units::secondsPerMinute);
    }
    root["cycle_time_min_by_stage"] = std::move(stageTimes);
    root["gauge"] = {{"reading_mm", result.gaugeReading_mm},
                     {"remaining_stock_mm", result.remainingStock_mm}};
    const PartAccuracy accuracy = accuracyOf(result);
    root[isTraverse(result) ? "zones" : "sections"] = sectionsJson(result, accuracy);
    root["part"] = partJson(accuracy);
    root["peak"] = {{"normal_force_n", result.peakNormalForce_n},
                    {"normal_force_where", placeText(result.peakNormalForceAt)},
                    {"power_w", result.peakPower_w},
                    {"power_where", placeText(result.peakPowerAt)}};
    root["shop"] = shopJson(shopNumbers(result));
    if (const auto burn = burnStateOf(result)) {
        root["burn"] = burnJson(*burn);
    }
    root["constraints"] = constraintsJson(constraints);
    return printJson(root);
}

std::string statusSentence(const SimulationResult& result) {
    const std::string reached = "the gauge reads " + fixed(result.gaugeReading_mm, 5) + " mm, "
                                + fixed(result.remainingStock_mm * units::umPerMm, 3)
                                + " µm per side remain to the target";
    switch (result.status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize:
        return "the cycle cannot reach size: nothing more is removed; " + reached;
    case RunStatus::tooLong:
        return "the cycle is longer than " + std::to_string(maxVisits) + " visits of a radius; "
               + reached;
    case RunStatus::stopped: return "stopped; " + reached;
    case RunStatus::notSolved:
        return "the balance of the coupled sections was not solved; " + reached;
    }
    return {};
}

std::string resultText(const SimulationResult& result,
                       const std::vector<ConstraintResult>& constraints) {
    std::string text = printable(result.project.title) + '\n';
    text += "status               " + statusSentence(result) + '\n';
    text += "machining time       " + fixed(result.time_s / units::secondsPerMinute, 4) + " min\n";
    text += isTraverse(result) ? "double strokes       " : "revolutions          ";
    text += std::to_string(result.cycleCount) + " (by stage:";
    for (const int count : result.countsByStage) {
        text += ' ' + std::to_string(count);
    }
    text += ")\npeak normal force    " + fixed(result.peakNormalForce_n, 2) + " N at "
            + placeText(result.peakNormalForceAt) + '\n';
    text += "peak power           " + fixed(result.peakPower_w, 1) + " W at "
            + placeText(result.peakPowerAt) + '\n';
    text += accuracyText(result, accuracyOf(result)) + requirementsText(result, constraints);
    return text + shopText(shopNumbers(result));
}

std::string traceCsv(const SimulationResult& result, const Trajectory& trajectory) {
    const bool traverse = isTraverse(result);
    std::string csv = traverse ? "time_min,double_stroke,stage,zone,step,revolution,radius,"
                               : "time_min,revolution,stage,section,radius,";
    csv += "programmed_mm,actual_mm,accumulated_mm,radius_um,normal_force_n\n";
    const double nominal = result.project.part.diameter_mm / 2;
    for (const Pass& pass : trajectory.passes) {
        const Place& place = pass.place;
        std::string where =
            ',' + std::to_string(place.cycleCount) + ',' + std::to_string(place.stage) + ',';
        where += traverse ? std::string(zoneKey(place.zone)) + ',' + stepKey(place.step) + ','
                                + std::to_string(place.revolution)
                          : std::to_string(place.section);
        for (int k = 0; k < trajectory.radii; ++k) {
            const Visit& visit = trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
            csv += numberText(visit.time_s / units::secondsPerMinute) + where + ','
                   + std::to_string(k) + ',' + numberText(visit.programmed_mm) + ','
                   + numberText(visit.actual_mm) + ',' + numberText(visit.accumulated_mm) + ','
                   + numberText((visit.radius_mm - nominal) * units::umPerMm) + ','
                   + numberText(visit.normalForce_n) + '\n';
        }
    }
    return csv;
}

} // namespace sparkout::cli
