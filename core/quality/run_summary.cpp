// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/run_summary.h"

#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/project/part.h"
#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sparkout {

template <>
std::span<const Choice> choicesOf<RunStatus>() {
    static const std::array choices{
        Choice{"completed", SPARKOUT_NOOP("Choice", "completed")},
        Choice{"cannot_reach_size", SPARKOUT_NOOP("Choice", "cannot reach size")},
        Choice{"too_long", SPARKOUT_NOOP("Choice", "too long")},
        Choice{"stopped", SPARKOUT_NOOP("Choice", "stopped")},
        Choice{"not_solved", SPARKOUT_NOOP("Choice", "balance not solved")},
        Choice{"ground_away", SPARKOUT_NOOP("Choice", "ground away")}};
    return choices;
}

template <>
const StructInfo& tableOf<ZoneSummary>() {
    static const std::array rows{
        SPARKOUT_FIELD(ZoneSummary, zone, .label = "Zone"),
        SPARKOUT_FIELD(ZoneSummary, position_mm, .label = SPARKOUT_NOOP("Input", "Position"),
                       .unit = "mm"),
        SPARKOUT_FIELD(ZoneSummary, diameter_deviation_min_um,
                       .label = SPARKOUT_NOOP("Input", "Minimum diameter, deviation"),
                       .unit = "µm"),
        SPARKOUT_FIELD(ZoneSummary, diameter_deviation_max_um,
                       .label = SPARKOUT_NOOP("Input", "Maximum diameter, deviation"),
                       .unit = "µm"),
        SPARKOUT_FIELD(ZoneSummary, radial_runout_um,
                       .label = SPARKOUT_NOOP("Input", "Radial runout"), .unit = "µm"),
        SPARKOUT_FIELD(ZoneSummary, roundness_um, .label = SPARKOUT_NOOP("Input", "Roundness"),
                       .unit = "µm"),
        SPARKOUT_FIELD(ZoneSummary, peak_normal_force_n,
                       .label = SPARKOUT_NOOP("Input", "Maximum normal force"),
                       .unit = SPARKOUT_NOOP("Unit", "N")),
        SPARKOUT_FIELD(ZoneSummary, radii_um, .label = SPARKOUT_NOOP("Input", "Final radii"),
                       .unit = "µm")};
    static const StructInfo info =
        makeTable<ZoneSummary>(SPARKOUT_NOOP("Struct", "Zone or section"), rows);
    return info;
}

template <>
const StructInfo& tableOf<RequirementSummary>() {
    static const std::array rows{
        SPARKOUT_FIELD(RequirementSummary, name, .label = "Name"),
        SPARKOUT_FIELD(RequirementSummary, where, .label = SPARKOUT_NOOP("Input", "Worst place")),
        SPARKOUT_FIELD(RequirementSummary, limit, .label = SPARKOUT_NOOP("Input", "Limit")),
        SPARKOUT_FIELD(RequirementSummary, value, .label = SPARKOUT_NOOP("Input", "Value")),
        SPARKOUT_FIELD(RequirementSummary, margin, .label = SPARKOUT_NOOP("Input", "Margin")),
        SPARKOUT_FIELD(RequirementSummary, relative_margin,
                       .label = SPARKOUT_NOOP("Input", "Relative margin")),
        SPARKOUT_FIELD(RequirementSummary, ok, .label = SPARKOUT_NOOP("Input", "Holds"))};
    static const StructInfo info =
        makeTable<RequirementSummary>(SPARKOUT_NOOP("Struct", "Requirement"), rows);
    return info;
}

template <>
const StructInfo& tableOf<RunSummary>() {
    static const std::array rows{
        SPARKOUT_FIELD(RunSummary, status, .label = SPARKOUT_NOOP("Input", "How the cycle ended")),
        SPARKOUT_FIELD(RunSummary, cycle_time_min, .label = SPARKOUT_NOOP("Input", "Cycle time"),
                       .unit = SPARKOUT_NOOP("Unit", "min")),
        SPARKOUT_FIELD(RunSummary, count,
                       .label = SPARKOUT_NOOP("Input", "Double strokes or revolutions")),
        SPARKOUT_FIELD(RunSummary, counts_by_stage,
                       .label = SPARKOUT_NOOP("Input", "Double strokes or revolutions by stage")),
        SPARKOUT_FIELD(RunSummary, zones, .label = SPARKOUT_NOOP("Input", "Zones or sections")),
        SPARKOUT_FIELD(RunSummary, cylindricity_um, .label = SPARKOUT_NOOP("Input", "Cylindricity"),
                       .unit = "µm"),
        SPARKOUT_FIELD(RunSummary, total_runout_um,
                       .label = SPARKOUT_NOOP("Input", "Total radial runout"), .unit = "µm"),
        SPARKOUT_FIELD(RunSummary, peak_normal_force_n,
                       .label = SPARKOUT_NOOP("Input", "Maximum normal force"),
                       .unit = SPARKOUT_NOOP("Unit", "N")),
        SPARKOUT_FIELD(RunSummary, peak_power_w, .label = SPARKOUT_NOOP("Input", "Maximum power"),
                       .unit = SPARKOUT_NOOP("Unit", "W")),
        SPARKOUT_FIELD(RunSummary, requirements, .label = SPARKOUT_NOOP("Input", "Requirements"))};
    static const StructInfo info = makeTable<RunSummary>(SPARKOUT_NOOP("Struct", "Summary"), rows);
    return info;
}

namespace {

using units::umPerMm;

constexpr double sameShare = 1e-6;
const std::string requirementsPath = "/requirements";

std::string worstPlace(const ConstraintResult& constraint) {
    if (constraint.at || constraint.section >= 0) {
        const Zone zone = constraint.at ? constraint.at->zone : constraint.zone;
        const int section = constraint.at ? constraint.at->section : constraint.section;
        return sectionName(zone, section);
    }
    if (requirementOf(constraint.kind).scope == ConstraintScope::part) {
        return "part";
    }
    return constraint.stage > 0 ? "stage " + std::to_string(constraint.stage) : "cycle";
}

ZoneSummary zoneSummary(const SectionResult& section, const SectionAccuracy& accuracy,
                        double nominal_mm) {
    ZoneSummary zone;
    zone.zone = zoneKey(section.zone);
    zone.position_mm = section.position_mm;
    zone.diameter_deviation_min_um = section.diameterDeviationMin_mm * umPerMm;
    zone.diameter_deviation_max_um = section.diameterDeviationMax_mm * umPerMm;
    zone.radial_runout_um = section.radialRunout_mm * umPerMm;
    zone.roundness_um = accuracy.minimumZone.deviation() * umPerMm;
    zone.peak_normal_force_n = section.peakNormalForce_n;
    for (const double radius_mm : section.radii_mm) {
        if (std::isnan(radius_mm)) { // in a gap
            continue;
        }
        zone.radii_um.push_back((radius_mm - nominal_mm) * umPerMm);
    }
    return zone;
}

/// Normalises JSON as the reader of a file does.
std::string compact(const std::string& text) {
    return nlohmann::json::parse(text).dump();
}

bool sameNumber(double a, double b, const Field& field) {
    const bool length = std::string_view(field.unit) == "µm";
    const double allowed =
        length ? sameRadius_um : sameShare * std::max({1.0, std::abs(a), std::abs(b)});
    return a == b || std::abs(a - b) <= allowed;
}

bool sameList(const std::vector<double>& a, const std::vector<double>& b, const Field& field) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](double x, double y) { return sameNumber(x, y, field); });
}

/// The values by their paths; a requirement by its name, whatever precedes it. Rounding chooses
/// among equally bad places, so the worst place is left out.
std::map<std::string, Leaf> valuesOf(const RunSummary& summary) {
    std::map<std::string, Leaf> values;
    for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &summary)) {
        if (leaf.path != requirementsPath && !leaf.path.starts_with(requirementsPath + '/')) {
            values.emplace(leaf.path, leaf);
        }
    }
    for (const RequirementSummary& requirement : summary.requirements) {
        for (const Leaf& leaf : leavesOf(tableOf<RequirementSummary>(), &requirement)) {
            if (leaf.path != "/where") {
                values.emplace(requirementsPath + '/' + requirement.name + leaf.path, leaf);
            }
        }
    }
    return values;
}

/// Compares values of the kinds in a summary.
bool sameLeaf(const Leaf& a, const Leaf& b) {
    const Field& field = *a.field;
    switch (field.kind) {
    case Kind::number:
        return sameNumber(field.as<double>(a.owner), field.as<double>(b.owner), field);
    case Kind::integer: return field.as<int>(a.owner) == field.as<int>(b.owner);
    case Kind::boolean: return field.as<bool>(a.owner) == field.as<bool>(b.owner);
    case Kind::text: return field.as<std::string>(a.owner) == field.as<std::string>(b.owner);
    case Kind::choice: return field.getChoice(a.owner) == field.getChoice(b.owner);
    case Kind::numberList:
        return sameList(field.as<std::vector<double>>(a.owner),
                        field.as<std::vector<double>>(b.owner), field);
    case Kind::objectList: return field.size(a.owner) == field.size(b.owner);
    default: return true;
    }
}

} // namespace

RunSummary summarise(const SimulationResult& result, const PartAccuracy& accuracy,
                     const std::vector<ConstraintResult>& constraints) {
    RunSummary summary;
    summary.status = result.status;
    summary.cycle_time_min = result.time_s / units::secondsPerMinute;
    summary.count = result.cycleCount;
    summary.counts_by_stage.assign(result.countsByStage.begin(), result.countsByStage.end());
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        summary.zones.push_back(zoneSummary(result.sections[i], accuracy.sections[i],
                                            result.project.part->diameter_mm / 2));
    }
    summary.cylindricity_um = accuracy.minimumZone.deviation() * umPerMm;
    summary.total_runout_um = accuracy.totalRunout_mm * umPerMm;
    summary.peak_normal_force_n = result.peakNormalForce_n;
    summary.peak_power_w = result.peakPower_w;
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        if (!isComputed(constraint)) {
            continue;
        }
        summary.requirements.push_back({requirementOf(constraint.kind).key, worstPlace(constraint),
                                        constraint.limit, constraint.value, constraint.margin,
                                        constraint.relativeMargin, constraint.holds});
    }
    return summary;
}

KeptRun keptRun(const SimulationResult& result, const RunSummary& summary, std::string name,
                std::string when) {
    Project inputs = result.project;
    inputs.runs.clear();
    inputs.measured.reset(); // not used by the computation
    const std::string values = printJson(writeByTable(tableOf<RunSummary>(), &summary));
    return {std::move(name),
            std::move(when),
            result.engineVersion,
            {compact(writeProject(inputs))},
            {compact(values)}};
}

std::optional<ReadSummary> readSummary(std::string_view text) {
    Issues issues;
    const auto json = parseStrictly(text, issues);
    if (!json || !json->is_object()) {
        return std::nullopt;
    }
    ReadSummary read;
    std::vector<MissingKey> missing;
    readByTable(*json, tableOf<RunSummary>(), &read.summary, {}, issues, missing);
    for (const Issue& issue : issues) {
        if (issue.code != IssueCode::unknownKey) {
            return std::nullopt;
        }
    }
    const auto& requirements = read.summary.requirements;
    for (const MissingKey& key : missing) {
        const auto of = std::find_if(
            requirements.begin(), requirements.end(),
            [&key](const RequirementSummary& requirement) { return &requirement == key.owner; });
        read.missing.insert(of == requirements.end()
                                ? key.path
                                : requirementsPath + '/' + of->name + '/' + key.field->key);
    }
    return read;
}

std::vector<ChangedValue> changedSince(const ReadSummary& kept, const RunSummary& now) {
    const std::map<std::string, Leaf> after = valuesOf(now);
    std::vector<ChangedValue> changes;
    for (const auto& [path, leaf] : valuesOf(kept.summary)) {
        const auto found = after.find(path);
        const bool same = found != after.end() && sameLeaf(leaf, found->second);
        if (!same && !kept.missing.contains(path)) {
            changes.push_back(
                {path, leaf, found == after.end() ? std::nullopt : std::optional(found->second)});
        }
    }
    return changes;
}

} // namespace sparkout
