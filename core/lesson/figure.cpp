// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/figure.h"

#include "core/issue.h"
#include "core/project/conditions.h"
#include "core/project/project.h"
#include "core/text.h"

#include <array>

namespace sparkout {

namespace {

constexpr std::size_t figureCount = static_cast<std::size_t>(FigureName::count_);

constexpr std::array<FigureRow, figureCount> figureRows{{
    {FigureName::cycleTime,
     {"cycle_time_min", SPARKOUT_NOOP("Figure", "Cycle time")},
     "min",
     3,
     FigureScope::cycle,
     false},
    {FigureName::steps,
     {"steps", SPARKOUT_NOOP("Figure", "Double strokes or revolutions")},
     "",
     0,
     FigureScope::cycle,
     false},
    {FigureName::diameterSpread,
     {"diameter_spread_um", SPARKOUT_NOOP("Figure", "Maximum minus minimum diameter of the part")},
     "µm",
     2,
     FigureScope::cycle,
     true},
    {FigureName::cylindricity,
     {"cylindricity_um", SPARKOUT_NOOP("Figure", "Cylindricity")},
     "µm",
     2,
     FigureScope::cycle,
     true},
    {FigureName::totalRunout,
     {"total_runout_um", SPARKOUT_NOOP("Figure", "Total radial runout")},
     "µm",
     2,
     FigureScope::cycle,
     true},
    {FigureName::taper,
     {"taper_um", SPARKOUT_NOOP("Figure", "Taper, in radius")},
     "µm",
     2,
     FigureScope::cycle,
     true},
    {FigureName::crown,
     {"crown_um", SPARKOUT_NOOP("Figure", "Barrel (+) or saddle (−) shape, in radius")},
     "µm",
     2,
     FigureScope::cycle,
     true},
    {FigureName::peakForce,
     {"peak_normal_force_n", SPARKOUT_NOOP("Figure", "Maximum normal force")},
     SPARKOUT_NOOP("Unit", "N"),
     1,
     FigureScope::cycle,
     false},
    {FigureName::peakPower,
     {"peak_power_kw", SPARKOUT_NOOP("Figure", "Maximum power")},
     SPARKOUT_NOOP("Unit", "kW"),
     3,
     FigureScope::cycle,
     false},
    {FigureName::leastMargin,
     {"least_margin_percent", SPARKOUT_NOOP("Figure", "Minimum margin of a requirement")},
     "%",
     1,
     FigureScope::cycle,
     true},
    {FigureName::burnMargin,
     {"burn_margin_percent", SPARKOUT_NOOP("Figure", "Margin to burn")},
     "%",
     1,
     FigureScope::cycle,
     false},
    {FigureName::removalRate,
     {"removal_rate_mm2_s", SPARKOUT_NOOP("Figure", "Maximum specific removal rate")},
     "mm²/s",
     3,
     FigureScope::cycle,
     false},
    {FigureName::specificEnergy,
     {"specific_energy_j_mm3", SPARKOUT_NOOP("Figure", "Specific energy of the cycle")},
     "J/mm³",
     1,
     FigureScope::cycle,
     false},
    {FigureName::equivalentDiameter,
     {"equivalent_diameter_mm", SPARKOUT_NOOP("Figure", "Equivalent diameter Dₑ")},
     "mm",
     2,
     FigureScope::cycle,
     false},
    {FigureName::shearCoefficient,
     {"ks_n_mm2", SPARKOUT_NOOP("Figure", "Shear term of the force law, k_s")},
     SPARKOUT_NOOP("Unit", "N/mm²"),
     2,
     FigureScope::cycle,
     false},
    {FigureName::flatCoefficient,
     {"kr_n_mm15", SPARKOUT_NOOP("Figure", "Wear-flat term of the force law, k_r")},
     SPARKOUT_NOOP("Unit", "N/mm^1.5"),
     2,
     FigureScope::cycle,
     false},
    {FigureName::burnFreeFeed,
     {"burn_free_feed_um",
      SPARKOUT_NOOP("Figure", "Maximum actual feed without burn at the finished size")},
     "µm",
     2,
     FigureScope::cycle,
     false},
    {FigureName::stageSteps,
     {"stage_steps", SPARKOUT_NOOP("Figure", "Double strokes or revolutions of the stage")},
     "",
     0,
     FigureScope::stage,
     false},
    {FigureName::stageTime,
     {"stage_time_min", SPARKOUT_NOOP("Figure", "Time of the stage")},
     "min",
     3,
     FigureScope::stage,
     false},
    {FigureName::stageDepth,
     {"stage_depth_um", SPARKOUT_NOOP("Figure", "Maximum actual feed of a pass of the stage")},
     "µm",
     2,
     FigureScope::stage,
     false},
    {FigureName::stageForce,
     {"stage_force_n", SPARKOUT_NOOP("Figure", "Maximum normal force of the stage")},
     SPARKOUT_NOOP("Unit", "N"),
     1,
     FigureScope::stage,
     false},
    {FigureName::stagePower,
     {"stage_power_kw", SPARKOUT_NOOP("Figure", "Maximum power of the stage")},
     SPARKOUT_NOOP("Unit", "kW"),
     3,
     FigureScope::stage,
     false},
    {FigureName::compliance,
     {"compliance_mm_per_n", SPARKOUT_NOOP("Figure", "Compliance")},
     SPARKOUT_NOOP("Unit", "mm/N"),
     6,
     FigureScope::place,
     false},
    {FigureName::deviationLeast,
     {"deviation_least_um", SPARKOUT_NOOP("Figure", "Minimum diameter, deviation")},
     "µm",
     2,
     FigureScope::place,
     true},
    {FigureName::deviationMost,
     {"deviation_most_um", SPARKOUT_NOOP("Figure", "Maximum diameter, deviation")},
     "µm",
     2,
     FigureScope::place,
     true},
    {FigureName::deviationMean,
     {"deviation_mean_um", SPARKOUT_NOOP("Figure", "Mean diameter, deviation")},
     "µm",
     2,
     FigureScope::place,
     true},
    {FigureName::radialRunout,
     {"radial_runout_um", SPARKOUT_NOOP("Figure", "Radial runout")},
     "µm",
     2,
     FigureScope::place,
     true},
    {FigureName::roundness,
     {"roundness_um", SPARKOUT_NOOP("Figure", "Roundness")},
     "µm",
     2,
     FigureScope::place,
     true},
    {FigureName::roughness,
     {"roughness_ra_um", SPARKOUT_NOOP("Figure", "Roughness Ra")},
     "µm",
     3,
     FigureScope::place,
     true},
    {FigureName::placeForce,
     {"place_force_n", SPARKOUT_NOOP("Figure", "Maximum normal force in the zone")},
     SPARKOUT_NOOP("Unit", "N"),
     1,
     FigureScope::place,
     false},
    {FigureName::programmedFeed,
     {"programmed_feed_um", SPARKOUT_NOOP("Figure", "Programmed feed")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::actualFeed,
     {"actual_feed_um", SPARKOUT_NOOP("Figure", "Actual feed")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::lag,
     {"lag_um", SPARKOUT_NOOP("Figure", "Programmed minus actual feed, accumulated")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::accumulatedFeed,
     {"accumulated_feed_um", SPARKOUT_NOOP("Figure", "Accumulated actual feed")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::stockLeft,
     {"stock_left_um", SPARKOUT_NOOP("Figure", "Stock left, per side")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::force,
     {"normal_force_n", SPARKOUT_NOOP("Figure", "Normal force")},
     SPARKOUT_NOOP("Unit", "N"),
     1,
     FigureScope::step,
     false},
    {FigureName::runoutAfter,
     {"runout_after_um", SPARKOUT_NOOP("Figure", "Maximum minus minimum radius after the pass")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::damagedLayer,
     {"damaged_layer_um", SPARKOUT_NOOP("Figure", "Deepest layer damaged by heat")},
     "µm",
     1,
     FigureScope::step,
     false},
    {FigureName::burnLimit,
     {"burn_limit_um",
      SPARKOUT_NOOP("Figure", "Maximum actual feed without burn at the stock left")},
     "µm",
     2,
     FigureScope::step,
     false},
    {FigureName::batchBad,
     {"batch_bad_percent", SPARKOUT_NOOP("Figure", "Rejected parts of the batch")},
     "%",
     1,
     FigureScope::batch,
     false},
    {FigureName::batchMean,
     {"batch_mean_um", SPARKOUT_NOOP("Figure", "Mean over the batch, mean diameter, deviation")},
     "µm",
     2,
     FigureScope::batchPlace,
     false},
    {FigureName::batchDeviation,
     {"batch_sd_um", SPARKOUT_NOOP("Figure", "Standard deviation over the batch, mean diameter")},
     "µm",
     3,
     FigureScope::batchPlace,
     false},
    {FigureName::batchMeanHalf,
     {"batch_mean_half_um",
      SPARKOUT_NOOP("Figure", "Half of the Student interval of the mean, 95 %")},
     "µm",
     3,
     FigureScope::batchPlace,
     false},
    {FigureName::batchPp,
     {"batch_pp", SPARKOUT_NOOP("Figure", "Pp of the mean diameter")},
     "",
     2,
     FigureScope::batchPlace,
     false},
    {FigureName::batchPpk,
     {"batch_ppk", SPARKOUT_NOOP("Figure", "Ppk of the mean diameter")},
     "",
     2,
     FigureScope::batchPlace,
     false},
    {FigureName::bestTime,
     {"best_time_min", SPARKOUT_NOOP("Figure", "Time of the quickest cycle of the search, proved")},
     "min",
     3,
     FigureScope::search,
     false},
    {FigureName::levelsBestTime,
     {"levels_best_time_min",
      SPARKOUT_NOOP("Figure", "Time of the quickest cycle of whole levels of stock, proved")},
     "min",
     3,
     FigureScope::search,
     false},
    {FigureName::levelsRuleTime,
     {"levels_rule_time_min", SPARKOUT_NOOP("Figure", "Time of the cycle of dynamic programming")},
     "min",
     3,
     FigureScope::search,
     false},
    {FigureName::levelsRuleGap,
     {"levels_rule_gap_percent",
      SPARKOUT_NOOP("Figure", "Excess of the cycle of dynamic programming over the quickest one")},
     "%",
     1,
     FigureScope::search,
     false},
}};

constexpr std::array<Choice, figureCount> figureChoices = [] {
    std::array<Choice, figureCount> choices{};
    for (std::size_t i = 0; i < figureCount; ++i) {
        choices[i] = figureRows[i].choice;
    }
    return choices;
}();

static_assert([] {
    for (std::size_t i = 0; i < figureCount; ++i) {
        if (figureRows[i].name != static_cast<FigureName>(i)) {
            return false;
        }
    }
    return true;
}());

} // namespace

static_assert(CountOrWord<PlaceName>);

std::span<const Choice> PlaceName::words() {
    static constexpr std::array words{Choice{"rz1", "РЗ1"}, Choice{"nz", "НЗ"},
                                      Choice{"rz2", "РЗ2"}};
    return words;
}

Phrase PlaceName::expected() {
    return Phrase::zoneOrSection;
}

PlaceName placeName(const Project& project, std::size_t index) {
    return project.operation->travels ? PlaceName::ofWord(index)
                                      : PlaceName::ofNumber(static_cast<int>(index));
}

bool hasPlace(const Project& project, const PlaceName& place) {
    const bool isOfKind =
        project.operation->travels ? place.zone.has_value() : place.section.has_value();
    return isOfKind && place.index() < static_cast<std::size_t>(placeCount(project));
}

const FigureRow& rowOf(FigureName name) {
    return figureRows[static_cast<std::size_t>(name)];
}

template <>
std::span<const Choice> choicesOf<FigureName>() {
    return figureChoices;
}

template <>
std::span<const Choice> choicesOf<Step>() {
    static constexpr std::array choices{
        Choice{"whole", SPARKOUT_NOOP("Choice", "the whole double stroke")},
        Choice{"E1", "E1"},
        Choice{"E2", "E2"},
        Choice{"E3", "E3"},
        Choice{"E4", "E4"},
        Choice{"E5", "E5"}};
    return choices;
}

template <>
const StructInfo& tableOf<Figure>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Figure, name, .label = SPARKOUT_NOOP("Input", "Figure"), .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "Name of the quantity; it contains the unit.")),
        SPARKOUT_FIELD(Figure, place, .label = SPARKOUT_NOOP("Input", "Zone or section"),
                       .hard = {0, 100000}, .nullMeaning = SPARKOUT_NOOP("Input", "none is needed"),
                       .hint = SPARKOUT_NOOP(
                           "Input", "A section by its number from 0, as in a project file.")),
        SPARKOUT_FIELD(Figure, stage, .label = SPARKOUT_NOOP("Input", "Stage"), .hard = {1, 100},
                       .nullMeaning = SPARKOUT_NOOP("Input", "none is needed, or the last one"),
                       .hint = SPARKOUT_NOOP("Input", "Counted from 1.")),
        SPARKOUT_FIELD(Figure, count,
                       .label = SPARKOUT_NOOP("Input", "Double stroke or revolution"),
                       .hard = {1, 10000000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the last one of the stage"),
                       .hint = SPARKOUT_NOOP("Input", "Number within the cycle, counted from 1.")),
        SPARKOUT_FIELD(Figure, step, .label = SPARKOUT_NOOP("Input", "Step of the double stroke"),
                       .sparse = true, .hint = SPARKOUT_NOOP("Input", "In a traverse cycle.")),
    };
    static const StructInfo info = makeTable<Figure>(SPARKOUT_NOOP("Struct", "Figure"), rows);
    return info;
}

} // namespace sparkout
