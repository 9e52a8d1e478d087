// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/result_json.h"

#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/waviness_outputs.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace sparkout {

namespace {

std::optional<Interval> interval_um(const FinishedSurface& surface, double low_mm, double high_mm) {
    return surface.stated(Interval{low_mm * units::umPerMm, high_mm * units::umPerMm});
}

constexpr Output<SectionResult> positionRows[] = {
    {{.key = "position_mm",
      .label = SPARKOUT_NOOP("Output", "From the headstock end"),
      .unit = "mm"},
     [](const SectionResult& s) { return s.position_mm; }},
    {{.key = "compliance_mm_per_n", .label = SPARKOUT_NOOP("Output", "Compliance"), .unit = "mm/N"},
     [](const SectionResult& s) { return s.compliance_mm_per_n; }},
};

/// An output of every zone and, without a key, one of the form of a zone with several sections.
constexpr Output<ZoneFigures> roundnessRow(const char* key) {
    return {
        {.key = key,
         .label = SPARKOUT_NOOP("Output", "Roundness, minimum zone"),
         .brief = SPARKOUT_NOOP("Output", "Roundness"),
         .unit = "µm",
         .hint = SPARKOUT_NOOP("Output", "Minimum zone, of the least round section of the zone."),
         .knowsMachine = isRoundnessKnown},
        [](const ZoneFigures& z) { return z.surface.um(z.accuracy->minimumZone.deviation()); }};
}

/// The columns of tables are those with a label. They have the maximum Ra of an estimate by its own
/// factor, files by the ratio of both: the last digit may differ.
constexpr Output<ZoneFigures> rowsOfZone[] = {
    {{.label = SPARKOUT_NOOP("Output", "Minimum diameter from nominal"), .unit = "µm"},
     [](const ZoneFigures& z) { return z.surface.um(z.section->diameterDeviationMin_mm); }},
    {{.label = SPARKOUT_NOOP("Output", "Maximum diameter from nominal"), .unit = "µm"},
     [](const ZoneFigures& z) { return z.surface.um(z.section->diameterDeviationMax_mm); }},
    {{.key = "diameter_deviation_um",
      .unit = "µm",
      .hint = "minimum and maximum diameter from nominal; null where strips stay uncut"},
     [](const ZoneFigures& z) {
         return interval_um(z.surface, z.section->diameterDeviationMin_mm,
                            z.section->diameterDeviationMax_mm);
     }},
    {{.key = "radial_runout_um",
      .label = SPARKOUT_NOOP("Output", "Radial runout"),
      .unit = "µm",
      .knowsMachine = isRunoutKnown},
     [](const ZoneFigures& z) { return z.surface.um(z.section->radialRunout_mm); }},
    roundnessRow("roundness_um"),
    {{.key = "roundness_least_squares_um",
      .label = SPARKOUT_NOOP("Output", "Roundness, least squares"),
      .unit = "µm",
      .knowsMachine = isRoundnessKnown},
     [](const ZoneFigures& z) { return z.surface.um(z.accuracy->leastSquares.deviation()); }},
    {{.key = "roughness_ra_um",
      .unit = "µm",
      .hint = "roughness Ra, of an estimate its minimum; null where none is required"},
     [](const ZoneFigures& z) { return z.ra_um(z.roughness.least); }},
    {{.key = "roughness_ra_most_um",
      .unit = "µm",
      .hint = "maximum roughness Ra of an estimate; null where Ra is measured"},
     [](const ZoneFigures& z) {
         const std::optional<double> least = z.ra_um(z.roughness.least);
         return least ? z.roughness.greatestOf(*least) : std::nullopt;
     }},
    {{.key = "peak_normal_force_n",
      .label = SPARKOUT_NOOP("Output", "Maximum normal force"),
      .unit = "N"},
     [](const ZoneFigures& z) { return z.section->peakNormalForce_n; }},
    {{.label = SPARKOUT_NOOP("Output", "Roughness Ra"), .unit = "µm"},
     [](const ZoneFigures& z) { return z.ra_um(z.roughness.least); },
     nullptr,
     [](const ZoneFigures& z) { return z.section->lastCut.has_value(); }},
    {{.label = SPARKOUT_NOOP("Output", "Maximum roughness Ra of the estimate"), .unit = "µm"},
     [](const ZoneFigures& z) { return z.ra_um(z.roughness.most); },
     nullptr,
     [](const ZoneFigures& z) { return z.section->lastCut && !z.roughness.isMeasured(); }},
};

constexpr Output<ZoneFigures> evenLobesRows[] = {
    {{.label = SPARKOUT_NOOP("Output", "Minimum diameter with even lobes, from nominal"),
      .unit = "µm"},
     [](const ZoneFigures& z) { return z.surface.um(z.ifEven->least_mm); }},
    {{.label = SPARKOUT_NOOP("Output", "Maximum diameter with even lobes, from nominal"),
      .unit = "µm"},
     [](const ZoneFigures& z) { return z.surface.um(z.ifEven->most_mm); }},
    {{.key = "diameter_deviation_even_lobes_um",
      .unit = "µm",
      .hint = "minimum and maximum diameter from nominal with an even number of lobes, where the "
              "number is not known"},
     [](const ZoneFigures& z) {
         return interval_um(z.surface, z.ifEven->least_mm, z.ifEven->most_mm);
     }},
};

constexpr Output<ZoneFigures> zoneFormRows[] = {
    roundnessRow(""),
    {{.key = "cylindricity_um",
      .label = SPARKOUT_NOOP("Output", "Cylindricity, minimum zone"),
      .brief = SPARKOUT_NOOP("Output", "Cylindricity"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Minimum zone, over all sections of the zone."),
      .knowsMachine = isRoundnessKnown},
     [](const ZoneFigures& z) { return z.surface.um(z.form->cylindricity_mm); }},
    {{.key = "total_runout_um",
      .label = SPARKOUT_NOOP("Output", "Total runout"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP(
          "Output",
          "About the centre axis, over all sections, including the machine's own runout."),
      .knowsMachine = isRunoutKnown},
     [](const ZoneFigures& z) { return z.surface.um(z.form->totalRunout_mm); }},
    {{.key = "taper_um",
      .label = SPARKOUT_NOOP("Output", "Taper"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius at the zone's last section minus that at its "
                                      "first, on the straight line through them.")},
     [](const ZoneFigures& z) { return z.surface.um(z.form->profile.taper_mm); }},
    {{.key = "crown_um",
      .label = SPARKOUT_NOOP("Output", "Crown"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius in the zone's middle minus that at its ends: "
                                      "above 0 a barrel, below it a saddle.")},
     [](const ZoneFigures& z) { return z.surface.um(z.form->profile.crown_mm); }},
};

constexpr Output<ZoneSectionFigures> zoneSectionRows[] = {
    {{.key = "diameter_deviation_um",
      .unit = "µm",
      .hint = "minimum and maximum diameter from nominal"},
     [](const ZoneSectionFigures& z) {
         return interval_um(z.surface, z.section.diameterDeviationMin_mm,
                            z.section.diameterDeviationMax_mm);
     }},
    {{.key = "radial_runout_um", .unit = "µm", .hint = "with the machine's own"},
     [](const ZoneSectionFigures& z) { return z.surface.um(z.section.radialRunout_mm); }},
    {{.key = "mean_radius_um", .unit = "µm", .hint = "mean radius from nominal"},
     [](const ZoneSectionFigures& z) {
         return z.surface.um(meanOfGround(z.section.radii_mm) - z.nominalRadius_mm);
     }},
};

constexpr Output<PartFigures> rowsOfPart[] = {
    {{.key = "cylindricity_um", .unit = "µm", .hint = "minimum zone"},
     [](const PartFigures& p) { return p.surface.um(p.accuracy.minimumZone.deviation()); }},
    {{.key = "cylindricity_least_squares_um", .unit = "µm", .hint = "least squares"},
     [](const PartFigures& p) { return p.surface.um(p.accuracy.leastSquares.deviation()); }},
    {{.key = "total_runout_um", .unit = "µm", .hint = "about the centre axis, over all sections"},
     [](const PartFigures& p) { return p.surface.um(p.accuracy.totalRunout_mm); }},
    {{.key = "taper_um",
      .unit = "µm",
      .hint = "mean radius at the last section less that at the first"},
     [](const PartFigures& p) { return p.surface.um(p.accuracy.profile.taper_mm); }},
    {{.key = "crown_um", .unit = "µm", .hint = "mean radius in the middle less that at the ends"},
     [](const PartFigures& p) { return p.surface.um(p.accuracy.profile.crown_mm); }},
    {{.key = "form", .hint = "straight, taper, barrel or saddle"},
     [](const PartFigures& p) {
         return p.surface.stated(std::string(formKey(p.accuracy.profile.form)));
     }},
};

constexpr Output<BurnState> burnRows[] = {
    {{.key = "depth_of_cut_um",
      .unit = "µm",
      .hint = "depth of cut of the pass nearest to burning"},
     [](const BurnState& b) { return b.visit.depth_mm * units::umPerMm; }},
    {{.key = "limit_depth_um", .unit = "µm", .hint = "maximum depth of cut for that stock"},
     [](const BurnState& b) { return b.limitDepth_mm * units::umPerMm; }},
    {{.key = "stock_left_um", .unit = "µm", .hint = "stock per side left after that pass"},
     [](const BurnState& b) { return b.visit.stock_mm * units::umPerMm; }},
    {{.key = "damaged_depth_um", .unit = "µm", .hint = "depth of the damaged layer"},
     [](const BurnState& b) { return b.damagedDepth_mm * units::umPerMm; }},
    {{.key = "rise_at_stock_left_k",
      .unit = "K",
      .hint = "temperature rise of the finished surface"},
     [](const BurnState& b) { return b.rise_k; }},
};

} // namespace

std::optional<double> ZoneFigures::ra_um(double factor) const {
    return section->lastCut
               ? surface.um(RoughnessModel(*project, factor).roughness(*section->lastCut))
               : std::nullopt;
}

std::vector<ZoneFigures> zonesOf(const SimulationResult& result, const PartAccuracy& accuracy) {
    const bool isRough = std::ranges::any_of(
        result.sections, [](const SectionResult& section) { return section.lastCut.has_value(); });
    const RoughnessFactor factor = isRough ? roughnessFactor(result.project) : RoughnessFactor();
    const FinishedSurface surface(result.project);
    std::vector<ZoneFigures> zones;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        zones.push_back({&result.project, &result.sections[i], &accuracy.sections.at(i),
                         accuracy.zones.empty() ? nullptr : &accuracy.zones.at(i),
                         i < result.ifEven.size() ? &result.ifEven[i] : nullptr, factor, surface});
    }
    return zones;
}

std::span<const Output<SectionResult>> positionOutputs() {
    return positionRows;
}

std::span<const Output<ZoneFigures>> zoneOutputs() {
    return rowsOfZone;
}

std::span<const Output<ZoneFigures>> evenLobesOutputs() {
    return evenLobesRows;
}

std::span<const Output<ZoneFigures>> zoneFormOutputs() {
    return zoneFormRows;
}

std::span<const Output<ZoneSectionFigures>> zoneSectionOutputs() {
    return zoneSectionRows;
}

std::span<const Output<PartFigures>> partOutputs() {
    return rowsOfPart;
}

std::span<const Output<BurnState>> burnOutputs() {
    return burnRows;
}

namespace {

using nlohmann::ordered_json;

/// Whether the machine's own form error is included in these values.
ordered_json machineJson(const Project& project, std::initializer_list<ConstraintKind> kinds) {
    ordered_json known;
    for (const ConstraintKind kind : kinds) {
        known[requirementOf(kind).key] = knowsMachine(kind, project);
    }
    return known;
}

/// The radii from nominal; null where strips stay uncut.
ordered_json radiiJson(const ZoneFigures& zone) {
    if (!zone.surface.isWhole()) {
        return nullptr;
    }
    ordered_json radii = ordered_json::array();
    for (const double radius_mm : zone.section->radii_mm) {
        radii.push_back((radius_mm - zone.project->part->diameter_mm / 2) * units::umPerMm);
    }
    return radii;
}

ordered_json wavesJson(const PlaceWaves& waves) {
    constexpr double least_um = 1e-3; // lower amplitudes are left out
    ordered_json json = outputsJson(wavinessOutputs(), waves);
    ordered_json orders = ordered_json::array();
    for (const Harmonic& each : waves.waves ? waves.waves->orders : std::vector<Harmonic>()) {
        if (const double amplitude_um = each.amplitude_mm * units::umPerMm;
            amplitude_um >= least_um) {
            orders.push_back({{"order", each.lobes}, {"amplitude_um", amplitude_um}});
        }
    }
    json["orders"] = waves.waves ? std::move(orders) : ordered_json(nullptr);
    return json;
}

/// The sections of a zone with several.
ordered_json zoneSectionsJson(const SimulationResult& result, const ZoneFigures& zone,
                              std::size_t index) {
    ordered_json list = ordered_json::array();
    const std::size_t inZone = result.zoneSections.size() / result.sections.size();
    for (std::size_t i = index * inZone; i < (index + 1) * inZone; ++i) {
        const SectionResult& section = result.zoneSections[i];
        ordered_json json = outputsJson(positionOutputs(), section);
        json.update(outputsJson(zoneSectionOutputs(),
                                {section, zone.project->part->diameter_mm / 2, zone.surface}));
        list.push_back(std::move(json));
    }
    return list;
}

/// The zones as an object, or the sections as a list.
ordered_json sectionsJson(const SimulationResult& result, const PartAccuracy& accuracy) {
    const bool isObject = result.project.operation->travels;
    ordered_json all = isObject ? ordered_json::object() : ordered_json::array();
    const std::vector<ZoneFigures> zones = zonesOf(result, accuracy);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const ZoneFigures& zone = zones[i];
        ordered_json one = outputsJson(zoneOutputs(), zone);
        one.update(outputsJson(positionOutputs(), *zone.section));
        one["radii_um"] = radiiJson(zone);
        one["machine_known"] =
            machineJson(result.project, {ConstraintKind::radialRunout, ConstraintKind::roundness});
        if (zone.ifEven) {
            one.update(outputsJson(evenLobesOutputs(), zone));
        }
        if (const std::optional<PlaceWaves> waves = placeWaves(result, i)) {
            one["waviness"] = wavesJson(*waves);
        }
        if (zone.form) {
            one.update(outputsJson(zoneFormOutputs(), zone));
            one["sections"] = zoneSectionsJson(result, zone, i);
        }
        isObject ? void(all[zoneKey(zone.section->zone)] = std::move(one))
                 : all.push_back(std::move(one));
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
    root["part"] = outputsJson(partOutputs(), {accuracy, surface});
    root["part"]["machine_known"] =
        machineJson(result.project, {ConstraintKind::cylindricity, ConstraintKind::totalRunout});
    root["peak"] = {{"normal_force_n", result.peakNormalForce_n},
                    {"normal_force_where", placeText(result.peakNormalForceAt)},
                    {"power_w", result.peakPower_w},
                    {"power_where", placeText(result.peakPowerAt)}};
    root["shop"] = shopJson(shopNumbers(result));
    if (const auto burn = burnStateOf(result)) {
        root["burn"] = outputsJson(burnOutputs(), *burn);
    }
    root["constraints"] = outputsJsonOfEach(requirementOutputs(), worstByKind(constraints));
    return printJson(root);
}

} // namespace sparkout
