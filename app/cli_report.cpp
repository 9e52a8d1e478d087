// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_report.h"

#include "app/cli_shop.h"
#include "core/project/strict_json.h"
#include "core/project/validate.h"
#include "core/units.h"

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

ordered_json zoneJson(const SimulationResult& result, const SectionResult& section) {
    const double nominal = result.project.part.diameter_mm / 2;
    ordered_json radii = ordered_json::array();
    for (const double radius : section.radii_mm) {
        radii.push_back((radius - nominal) * units::umPerMm);
    }
    return {{"diameter_deviation_um",
             {section.diameterDeviationMin_mm * units::umPerMm,
              section.diameterDeviationMax_mm * units::umPerMm}},
            {"radial_runout_um", section.radialRunout_mm * units::umPerMm},
            {"peak_normal_force_n", section.peakNormalForce_n},
            {"position_mm", section.position_mm},
            {"compliance_mm_per_n", section.compliance_mm_per_n},
            {"radii_um", std::move(radii)}};
}

ordered_json constraintJson(const ConstraintResult& constraint) {
    return {{"name", constraintName(constraint.kind)},
            {"limit", constraint.limit},
            {"value", constraint.value},
            {"margin", constraint.margin},
            {"relative_margin", constraint.relativeMargin},
            {"where", sectionName(constraint.zone, constraint.section)},
            {"ok", constraint.holds}};
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
    ordered_json zones = ordered_json::object();
    ordered_json sections = ordered_json::array();
    for (const SectionResult& section : result.sections) {
        ordered_json zone = zoneJson(result, section);
        isTraverse(result) ? void(zones[zoneKey(section.zone)] = std::move(zone))
                           : sections.push_back(std::move(zone));
    }
    isTraverse(result) ? root["zones"] = std::move(zones) : root["sections"] = std::move(sections);
    root["peak"] = {{"normal_force_n", result.peakNormalForce_n},
                    {"normal_force_where", placeText(result.peakNormalForceAt)},
                    {"power_w", result.peakPower_w},
                    {"power_where", placeText(result.peakPowerAt)}};
    root["shop"] = shopJson(shopNumbers(result));
    ordered_json list = ordered_json::array();
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        list.push_back(constraintJson(constraint));
    }
    root["constraints"] = std::move(list);
    ordered_json unchecked = ordered_json::array();
    for (const Field* field : uncheckedRequirements(result.project)) {
        unchecked.push_back(field->key);
    }
    root["not_checked"] = std::move(unchecked);
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
    text += "deviations, µm       min, max of the diameter; radial runout\n";
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        std::string name = "  " + sectionName(section.zone, static_cast<int>(i));
        name.resize(21, ' ');
        text += name + fixed(section.diameterDeviationMin_mm * units::umPerMm, 3) + ", "
                + fixed(section.diameterDeviationMax_mm * units::umPerMm, 3) + "; "
                + fixed(section.radialRunout_mm * units::umPerMm, 3) + '\n';
    }
    text += "requirements, µm     value, limit, margin at its worst place\n";
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        std::string name = std::string("  ") + constraintName(constraint.kind);
        name.resize(21, ' ');
        text += name + fixed(constraint.value, 3) + ", " + fixed(constraint.limit, 3) + ", "
                + fixed(constraint.margin, 3) + "  " + (constraint.holds ? "holds" : "FAILS")
                + " in " + sectionName(constraint.zone, constraint.section) + '\n';
    }
    std::string unchecked;
    for (const Field* field : uncheckedRequirements(result.project)) {
        unchecked += (unchecked.empty() ? "" : ", ") + std::string(field->key);
    }
    if (!unchecked.empty()) {
        text += "given, not checked   " + unchecked + '\n';
    }
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
