// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/requirement.h"

#include "core/process/force.h"
#include "core/project/member.h"
#include "core/project/wheel.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/drawing_constraints.h"
#include "core/text.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr RequirementDigits micrometreDigits{.printed = 3, .shown = 2};

} // namespace

constexpr std::array<Requirement, constraintKinds> requirementRows{{
    {.kind = ConstraintKind::diameterMin,
     .key = "diameter_min",
     .label = SPARKOUT_NOOP("Requirement", "Minimum diameter"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Min. diameter"),
     .broken = SPARKOUT_NOOP("Requirement", "diameter in %1 is %2 µm below the lower limit"),
     .unit = "µm",
     .digits = micrometreDigits,
     .isDeviation = true,
     .isLeast = true,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/lower_deviation_um"},
     .isCapable = true,
     .evaluate = evaluateLeastDiameter},
    {.kind = ConstraintKind::diameterMax,
     .key = "diameter_max",
     .label = SPARKOUT_NOOP("Requirement", "Maximum diameter"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Max. diameter"),
     .broken = SPARKOUT_NOOP("Requirement", "diameter in %1 is %2 µm above the upper limit"),
     .unit = "µm",
     .digits = micrometreDigits,
     .isDeviation = true,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/upper_deviation_um"},
     .isCapable = true,
     .evaluate = evaluateLargestDiameter},
    {.kind = ConstraintKind::radialRunout,
     .key = "radial_runout",
     .label = SPARKOUT_NOOP("Requirement", "Radial runout"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Radial runout"),
     .broken = SPARKOUT_NOOP("Requirement", "radial runout in %1 is %2 µm above its limit"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/radial_runout_um"},
     .isCapable = true,
     .evaluate = evaluateRadialRunout,
     .sheet = sheetOfRadialRunout},
    {.kind = ConstraintKind::roundness,
     .key = "roundness",
     .label = SPARKOUT_NOOP("Requirement", "Roundness"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Roundness"),
     .measuredBy =
         SPARKOUT_NOOP("Requirement", "Between the circles of the minimum zone, MZCI (ISO 12181)"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/roundness_um"},
     .isCapable = true,
     .evaluate = evaluateRoundness,
     .sheet = sheetOfRoundness},
    {.kind = ConstraintKind::cylindricity,
     .key = "cylindricity",
     .label = SPARKOUT_NOOP("Requirement", "Cylindricity"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Cylindricity"),
     .measuredBy = SPARKOUT_NOOP("Requirement",
                                 "Between the cylinders of the minimum zone, MZCY (ISO 12180)"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::part,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/cylindricity_um"},
     .isCapable = true,
     .evaluate = evaluateCylindricity,
     .sheet = sheetOfCylindricity},
    {.kind = ConstraintKind::totalRunout,
     .key = "total_runout",
     .label = SPARKOUT_NOOP("Requirement", "Total runout"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Total runout"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::part,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/total_runout_um"},
     .isCapable = true,
     .evaluate = evaluateTotalRunout,
     .sheet = sheetOfTotalRunout},
    {.kind = ConstraintKind::waviness,
     .key = "waviness",
     .label = SPARKOUT_NOOP("Requirement", "Waviness"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Waviness"),
     .measuredBy =
         SPARKOUT_NOOP("Requirement", "From peak to valley, without the orders below half of the "
                                      "wheel's"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/waviness_um"},
     .isCapable = true,
     .evaluate = evaluateWaviness},
    {.kind = ConstraintKind::roughness,
     .key = "roughness",
     .label = SPARKOUT_NOOP("Requirement", "Roughness Ra"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Roughness Ra"),
     .limitName = SPARKOUT_NOOP("Requirement", "Ra, last cut"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::section,
     .source = LimitSource::input,
     .inputs = {"/part/tolerance/roughness_ra_um"},
     .estimates = {"/wheel/grain_tip_angle_deg", "/wheel/dressing_chipping_mm",
                   "/wheel/roughness_factor"},
     .evaluate = evaluateRoughness,
     .sheet = sheetOfRoughness,
     .depthLimit = roughnessDepth},
    {.kind = ConstraintKind::burn,
     .key = "burn",
     .label = SPARKOUT_NOOP("Requirement", "Depth of cut without burn"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Depth, burn"),
     .limitName = SPARKOUT_NOOP("Requirement", "burn"),
     .unit = "µm",
     .digits = micrometreDigits,
     .scope = ConstraintScope::pass,
     .source = LimitSource::model,
     .inputs = {"/material/burn_rise_k"},
     .estimates = {"/material/friction", "/material/burn_rise_k", "/material/heat_share"},
     .evaluate = evaluateBurn,
     .sheet = sheetOfBurn,
     .depthLimit = burnDepth},
    {.kind = ConstraintKind::selfSharpening,
     .key = "self_sharpening",
     .label = SPARKOUT_NOOP("Requirement", "Contact pressure on the wheel"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Pressure"),
     .limitName = SPARKOUT_NOOP("Requirement", "self-sharpening"),
     .unit = "MPa",
     .scope = ConstraintScope::pass,
     .source = LimitSource::model,
     .inputs = {"/wheel/grain_surface_energy_j_m2", "/wheel/grain_modulus_gpa",
                "/wheel/bond_surface_energy_j_m2", "/wheel/bond_modulus_gpa"},
     .estimates = {"/wheel/grain_surface_energy_j_m2", "/wheel/grain_modulus_gpa",
                   "/wheel/bond_surface_energy_j_m2", "/wheel/bond_modulus_gpa"},
     .evaluate = evaluateSelfSharpening,
     .sheet = sheetOfSelfSharpening,
     .depthLimit = selfSharpeningDepth,
     .passBound = selfSharpeningBound},
    {.kind = ConstraintKind::wheelPower,
     .key = "wheel_power",
     .label = SPARKOUT_NOOP("Requirement", "Wheel drive power"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Wheel power"),
     .limitName = SPARKOUT_NOOP("Requirement", "wheel drive"),
     .unit = "kW",
     .scope = ConstraintScope::pass,
     .source = LimitSource::input,
     .inputs = {"/machine/wheel_drive_kw"},
     .sharedBySections = true,
     .estimates = {"/material/friction"},
     .evaluate = evaluateWheelPower,
     .sheet = sheetOfWheelPower,
     .depthLimit = wheelPowerDepth,
     .passBound = wheelPowerBound},
    {.kind = ConstraintKind::workPower,
     .key = "work_power",
     .label = SPARKOUT_NOOP("Requirement", "Work drive power"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Work power"),
     .limitName = SPARKOUT_NOOP("Requirement", "work drive"),
     .unit = "kW",
     .scope = ConstraintScope::pass,
     .source = LimitSource::input,
     .inputs = {"/machine/work_drive_kw"},
     .sharedBySections = true,
     .estimates = {"/material/friction"},
     .evaluate = evaluateWorkPower,
     .sheet = sheetOfWorkPower,
     .depthLimit = workPowerDepth,
     .passBound = workPowerBound},
    {.kind = ConstraintKind::rangeRadialFeed,
     .key = "range_radial_feed",
     .label = SPARKOUT_NOOP("Requirement", "Radial feed in range"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Radial feed"),
     .unit = "mm",
     .unitInFull = "mm/dbl stroke",
     .digits = {.printed = 5},
     .scope = ConstraintScope::setting,
     .source = LimitSource::range,
     .inputs = {"/machine/limits/radial_feed_mm"},
     .settingOfStage = "radial_feed_mm",
     .evaluate = evaluateRange},
    {.kind = ConstraintKind::rangeAxialFeed,
     .key = "range_axial_feed",
     .label = SPARKOUT_NOOP("Requirement", "Axial feed in range"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Axial feed"),
     .unit = "mm/min",
     .scope = ConstraintScope::setting,
     .source = LimitSource::range,
     .inputs = {"/machine/limits/axial_feed_mm_min"},
     .settingOfStage = "axial_feed_mm_min",
     .evaluate = evaluateRange},
    {.kind = ConstraintKind::rangePlungeFeed,
     .key = "range_plunge_feed",
     .label = SPARKOUT_NOOP("Requirement", "Plunge feed in range"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Plunge feed"),
     .unit = "mm/min",
     .scope = ConstraintScope::setting,
     .source = LimitSource::range,
     .inputs = {"/machine/limits/plunge_feed_mm_min"},
     .setting = "/machine/plunge_feed_mm_min",
     .settingOfStage = "radial_feed_mm_min",
     .evaluate = evaluateRange},
    {.kind = ConstraintKind::rangeContinuousFeed,
     .key = "range_continuous_feed",
     .label = SPARKOUT_NOOP("Requirement", "Continuous infeed in range"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Cont. infeed"),
     .unit = "mm/min",
     .scope = ConstraintScope::setting,
     .source = LimitSource::range,
     .inputs = {"/machine/limits/continuous_feed_mm_min"},
     .settingOfStage = "continuous_feed_mm_min",
     .evaluate = evaluateRange},
    {.kind = ConstraintKind::rangeWorkSpeed,
     .key = "range_work_speed",
     .label = SPARKOUT_NOOP("Requirement", "Work speed in range"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Work speed"),
     .unit = "rev/min",
     .scope = ConstraintScope::setting,
     .source = LimitSource::range,
     .inputs = {"/machine/limits/work_speed_rpm"},
     .setting = "/machine/work_speed_rpm",
     .evaluate = evaluateRange},
    {.kind = ConstraintKind::gaugeCommands,
     .key = "gauge_commands",
     .label = SPARKOUT_NOOP("Requirement", "Gauge commands"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Gauge commands"),
     .broken =
         SPARKOUT_NOOP("Requirement", "the stages need %2 more gauge commands than available"),
     .digits = {.printed = 0, .shown = 0},
     .scope = ConstraintScope::setting,
     .source = LimitSource::input,
     .inputs = {"/gauge/commands"},
     .setting = "/gauge/commands",
     .evaluate = evaluateGaugeCommands},
    {.kind = ConstraintKind::overlap,
     .key = "overlap",
     .label = SPARKOUT_NOOP("Requirement", "Overlap of the turns"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Overlap"),
     .broken = SPARKOUT_NOOP("Requirement",
                             "overlap B/s in %1 is %3, below 1: strips stay uncut, so size, form "
                             "and roughness are not known for the whole surface"),
     .isLeast = true,
     .scope = ConstraintScope::setting,
     .source = LimitSource::model,
     .settingOfStage = "axial_feed_mm_min",
     .evaluate = evaluateOverlap},
    {.kind = ConstraintKind::leastOverlap,
     .key = "least_overlap",
     .label = SPARKOUT_NOOP("Requirement", "Required overlap of a stage"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Minimum overlap"),
     .broken = SPARKOUT_NOOP("Requirement", "overlap B/s in %1 is %3, %2 below the minimum"),
     .isLeast = true,
     .scope = ConstraintScope::setting,
     .source = LimitSource::input,
     .inputs = {"/least_overlap"},
     .settingOfStage = "axial_feed_mm_min",
     .evaluate = evaluateOverlap},
    {.kind = ConstraintKind::leastOverlapLast,
     .key = "least_overlap_last",
     .label = SPARKOUT_NOOP("Requirement", "Required overlap of the last stage"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Overlap, last"),
     .broken =
         SPARKOUT_NOOP("Requirement", "overlap B/s in the last stage is %3, %2 below the minimum"),
     .isLeast = true,
     .scope = ConstraintScope::setting,
     .source = LimitSource::input,
     .inputs = {"/least_overlap_last"},
     .settingOfStage = "axial_feed_mm_min",
     .evaluate = evaluateOverlap},
    {.kind = ConstraintKind::leastSteps,
     .key = "least_steps",
     .label = SPARKOUT_NOOP("Requirement", "Steps of a stage"),
     .brief = SPARKOUT_NOOP("RequirementBrief", "Fewest steps"),
     .broken = SPARKOUT_NOOP(
         "Requirement", "%1 makes %3 double strokes or revolutions, %2 fewer than the minimum"),
     .digits = {.printed = 0, .shown = 0},
     .isLeast = true,
     .scope = ConstraintScope::setting,
     .source = LimitSource::input,
     .inputs = {"/least_steps"},
     .settingOfStage = "stock_mm",
     .evaluate = evaluateLeastSteps},
}};

namespace {

consteval bool standInOrder() {
    for (std::size_t i = 0; i < requirementRows.size(); ++i) {
        if (requirementRows[i].kind != static_cast<ConstraintKind>(i)) {
            return false;
        }
    }
    return true;
}
static_assert(standInOrder(), "one row for each kind, in the order of the kinds");

bool isGiven(const Project& project, const char* path) {
    const ConstMember member = findMember(project, path);
    return member.field->kind == Kind::optionalNumberList
               ? member.field->as<std::optional<std::vector<double>>>(member.owner).has_value()
               : numberIn(*member.field, member.owner).has_value();
}

} // namespace

const Requirement* requirementNamed(std::string_view key) {
    const auto* const found = std::ranges::find(requirementRows, key, &Requirement::key);
    return found == requirementRows.end() ? nullptr : found;
}

bool isAskedFor(const Requirement& row, const Project& project) {
    const auto given = [&project](const char* path) { return path && isGiven(project, path); };
    return !row.inputs.front() || std::ranges::any_of(row.inputs, given);
}

std::string missingInput(const Requirement& row, const Project& project) {
    for (const char* path : row.inputs) {
        if (path && !isGiven(project, path)) {
            return path;
        }
    }
    return {};
}

std::optional<double> statedLimit(const Requirement& row, const Project& project) {
    const ConstMember member = findMember(project, row.inputs.front());
    return numberIn(*member.field, member.owner);
}

std::vector<const Field*> estimatesBehind(const Project& project, ConstraintKind kind) {
    const Requirement& row = requirementOf(kind);
    if (row.scope == ConstraintScope::setting) {
        return {};
    }
    static const Project any;
    std::vector<const Field*> fields;
    const auto add = [&fields](const char* path) { fields.push_back(findMember(any, path).field); };
    const bool threshold = hasThreshold(project);
    for (const char* path :
         {threshold ? "/material/threshold_force_n_mm" : "/material/flow_stress_mpa",
          threshold ? "/material/specific_force_mpa" : dullnessPath(*project.wheel),
          "/machine/compliance_mm_per_n"}) {
        add(path);
    }
    for (const char* path : row.estimates) {
        if (path) {
            add(path);
        }
    }
    return fields;
}

} // namespace sparkout
