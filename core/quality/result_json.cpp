// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/result_json.h"

#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/project/part.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/result_names.h"
#include "core/quality/roughness.h"
#include "core/quality/shop_numbers.h"
#include "core/text.h"
#include "core/units.h"

#include <initializer_list>

namespace sparkout {

namespace {

std::optional<double> knownUm(const ZoneFormFigures& zone, double value_mm) {
    return zone.isKnown ? std::optional(value_mm * units::umPerMm) : std::nullopt;
}

constexpr Output<ZoneFormFigures> zoneFormRows[] = {
    {{.label = SPARKOUT_NOOP("Output", "Roundness, minimum zone"),
      .brief = SPARKOUT_NOOP("Output", "Roundness"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Minimum zone, of the least round section of the zone.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.worst->minimumZone.deviation()); }},
    {{.key = "cylindricity_um",
      .label = SPARKOUT_NOOP("Output", "Cylindricity, minimum zone"),
      .brief = SPARKOUT_NOOP("Output", "Cylindricity"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Minimum zone, over all sections of the zone.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->cylindricity_mm); }},
    {{.key = "total_runout_um",
      .label = SPARKOUT_NOOP("Output", "Total runout"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP(
          "Output",
          "About the centre axis, over all sections, including the machine's own runout.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->totalRunout_mm); }},
    {{.key = "taper_um",
      .label = SPARKOUT_NOOP("Output", "Taper"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius at the zone's last section minus that at its "
                                      "first, on the straight line through them.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->profile.taper_mm); }},
    {{.key = "crown_um",
      .label = SPARKOUT_NOOP("Output", "Crown"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius in the zone's middle minus that at its ends: "
                                      "above 0 a barrel, below it a saddle.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->profile.crown_mm); }},
};

} // namespace

std::span<const Output<ZoneFormFigures>> zoneFormOutputs() {
    return zoneFormRows;
}

namespace {

using nlohmann::ordered_json;

/// A value of the finished surface: null where strips stay uncut.
ordered_json statedJson(const FinishedSurface& surface, ordered_json value) {
    return surface.isWhole() ? std::move(value) : ordered_json(nullptr);
}

/// Whether the machine's own form error is included in these values.
ordered_json machineJson(const Project& project, std::initializer_list<ConstraintKind> kinds) {
    ordered_json known;
    for (const ConstraintKind kind : kinds) {
        known[requirementOf(kind).key] = knowsMachine(kind, project);
    }
    return known;
}

ordered_json zoneJson(const SimulationResult& result, std::size_t index,
                      const SectionAccuracy& accuracy) {
    const SectionResult& section = result.sections[index];
    const double nominal = result.project.part->diameter_mm / 2;
    ordered_json radii = ordered_json::array();
    for (const double radius : section.radii_mm) {
        radii.push_back((radius - nominal) * units::umPerMm);
    }
    ordered_json roughness, mostRoughness; // null where not required, or where Ra is measured
    if (section.lastCut) {
        const RoughnessFactor factor = roughnessFactor(result.project);
        const RoughnessModel model(result.project, factor.least);
        const double Ra_um = model.roughness(*section.lastCut) * units::umPerMm;
        roughness = Ra_um;
        if (!factor.isMeasured()) {
            mostRoughness = Ra_um * factor.most / factor.least;
        }
    }
    const FinishedSurface surface(result.project);
    const auto stated = [&surface](ordered_json value) {
        return statedJson(surface, std::move(value));
    };
    roughness = stated(std::move(roughness));
    mostRoughness = stated(std::move(mostRoughness));
    radii = stated(std::move(radii));
    ordered_json zone = {
        {"diameter_deviation_um",
         stated(ordered_json::array({section.diameterDeviationMin_mm * units::umPerMm,
                                     section.diameterDeviationMax_mm * units::umPerMm}))},
        {"radial_runout_um", stated(section.radialRunout_mm * units::umPerMm)},
        {"roundness_um", stated(accuracy.minimumZone.deviation() * units::umPerMm)},
        {"roundness_least_squares_um", stated(accuracy.leastSquares.deviation() * units::umPerMm)},
        {"roughness_ra_um", std::move(roughness)},
        {"roughness_ra_most_um", std::move(mostRoughness)},
        {"peak_normal_force_n", section.peakNormalForce_n},
        {"position_mm", section.position_mm},
        {"compliance_mm_per_n", section.compliance_mm_per_n},
        {"radii_um", std::move(radii)},
        {"machine_known",
         machineJson(result.project, {ConstraintKind::radialRunout, ConstraintKind::roundness})}};
    if (index < result.ifEven.size()) { // the number of lobes is not known
        const auto& [least_mm, most_mm] = result.ifEven[index];
        zone["diameter_deviation_even_lobes_um"] =
            stated(ordered_json::array({least_mm * units::umPerMm, most_mm * units::umPerMm}));
    }
    return zone;
}

ordered_json partJson(const PartAccuracy& accuracy, const Project& project) {
    const FinishedSurface surface(project);
    const auto stated = [&surface](double value_mm) {
        return statedJson(surface, value_mm * units::umPerMm);
    };
    return {{"cylindricity_um", stated(accuracy.minimumZone.deviation())},
            {"cylindricity_least_squares_um", stated(accuracy.leastSquares.deviation())},
            {"total_runout_um", stated(accuracy.totalRunout_mm)},
            {"taper_um", stated(accuracy.profile.taper_mm)},
            {"crown_um", stated(accuracy.profile.crown_mm)},
            {"form", statedJson(surface, formKey(accuracy.profile.form))},
            {"machine_known",
             machineJson(project, {ConstraintKind::cylindricity, ConstraintKind::totalRunout})}};
}

ordered_json burnJson(const BurnState& burn) {
    return {{"depth_of_cut_um", burn.visit.depth_mm * units::umPerMm},
            {"limit_depth_um", burn.limitDepth_mm * units::umPerMm},
            {"stock_left_um", burn.visit.stock_mm * units::umPerMm},
            {"damaged_depth_um", burn.damagedDepth_mm * units::umPerMm},
            {"rise_at_stock_left_k", burn.rise_k}};
}

/// Adds to a zone with several sections more than their worst values; null where strips stay uncut.
void addZoneSections(ordered_json& zone, const SimulationResult& result, std::size_t index,
                     const PartAccuracy& accuracy) {
    const FinishedSurface surface(result.project);
    const auto um = [&surface](double value_mm) {
        return statedJson(surface, value_mm * units::umPerMm);
    };
    zone.update(outputsJson(
        zoneFormOutputs(), {&accuracy.sections[index], &accuracy.zones[index], surface.isWhole()}));
    ordered_json list = ordered_json::array();
    const std::size_t inZone = result.zoneSections.size() / result.sections.size();
    for (std::size_t i = index * inZone; i < (index + 1) * inZone; ++i) {
        const SectionResult& section = result.zoneSections[i];
        list.push_back(
            {{"position_mm", section.position_mm},
             {"compliance_mm_per_n", section.compliance_mm_per_n},
             {"diameter_deviation_um", ordered_json::array({um(section.diameterDeviationMin_mm),
                                                            um(section.diameterDeviationMax_mm)})},
             {"radial_runout_um", um(section.radialRunout_mm)},
             {"mean_radius_um",
              um(meanOfGround(section.radii_mm) - result.project.part->diameter_mm / 2)}});
    }
    zone["sections"] = std::move(list);
}

/// The zones as an object, or the sections as a list.
ordered_json sectionsJson(const SimulationResult& result, const PartAccuracy& accuracy) {
    const bool zones = result.project.operation->travels;
    ordered_json all = zones ? ordered_json::object() : ordered_json::array();
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        ordered_json one = zoneJson(result, i, accuracy.sections[i]);
        if (!accuracy.zones.empty()) {
            addZoneSections(one, result, i, accuracy);
        }
        zones ? void(all[zoneKey(section.zone)] = std::move(one)) : all.push_back(std::move(one));
    }
    return all;
}

ordered_json shopJson(const ShopNumbers& shop) {
    ordered_json json = {{"stages", outputsJsonOfEach(shopColumnOutputs(), shop.stages)},
                         {"cycle", outputsJson(shopColumnOutputs(), shop.cycle)}};
    json.update(outputsJson(shopOutputs(), shop));
    return json;
}

} // namespace

std::string resultJson(const SimulationResult& result,
                       const std::vector<ConstraintResult>& constraints) {
    const Operation operation = result.project.operation;
    ordered_json root;
    root["status"] = statusKey(result.status);
    root["operation"] = operation->choice.key;
    root["engine_version"] = result.engineVersion;
    root["cycle_time_min"] = result.time_s / units::secondsPerMinute;
    root[operation->travels ? "double_strokes" : "revolutions"] = result.cycleCount;
    root[operation->travels ? "double_strokes_by_stage" : "revolutions_by_stage"] =
        result.countsByStage;
    ordered_json stageTimes = ordered_json::array();
    for (const double time_s : result.timeByStage_s) {
        stageTimes.push_back(time_s / units::secondsPerMinute);
    }
    root["cycle_time_min_by_stage"] = std::move(stageTimes);
    root["gauge"] = {{"reading_mm", result.gaugeReading_mm},
                     {"remaining_stock_mm", result.remainingStock_mm}};
    const FinishedSurface surface(result.project);
    if (!surface.isWhole()) {
        root["strips_uncut"] = true;
    }
    const PartAccuracy accuracy = accuracyOf(result);
    if (const double engaged = engagedShare(*result.project.part); engaged < 1) {
        root["engaged_share"] = engaged; // of the turn; radii in the gaps are null
    }
    root[operation->travels ? "zones" : "sections"] = sectionsJson(result, accuracy);
    root["part"] = partJson(accuracy, result.project);
    root["peak"] = {{"normal_force_n", result.peakNormalForce_n},
                    {"normal_force_where", placeText(result.peakNormalForceAt)},
                    {"power_w", result.peakPower_w},
                    {"power_where", placeText(result.peakPowerAt)}};
    root["shop"] = shopJson(shopNumbers(result));
    if (const auto burn = burnStateOf(result)) {
        root["burn"] = burnJson(*burn);
    }
    root["constraints"] = outputsJsonOfEach(requirementOutputs(), worstByKind(constraints));
    return printJson(root);
}

} // namespace sparkout
