// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/shop_numbers.h"

#include "core/process/force.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/ranges.h"
#include "core/quality/result_names.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

void keepLarger(Peak& peak, const Peak& other) {
    if (other.value > peak.value) {
        peak = other;
    }
}

StageSums add(const StageSums& a, const StageSums& b) {
    StageSums sum = a;
    sum.length_mm += b.length_mm;
    sum.removed_mm2 += b.removed_mm2;
    sum.rootLength_mm15 += b.rootLength_mm15;
    keepLarger(sum.depth_mm, b.depth_mm);
    keepLarger(sum.normalForce_n, b.normalForce_n);
    keepLarger(sum.power_w, b.power_w);
    return sum;
}

/// Turns sums into numbers, for one project.
class Shop {
public:
    explicit Shop(const Project& project)
        : m_law(forceLaw(project))
        , m_turn_s(units::secondsPerMinute / project.machine->work_speed_rpm)
        , m_girth_mm(std::numbers::pi * project.part->diameter_mm)
        , m_wheelSpeed_m_s(project.machine->wheel_speed_m_s)
        , m_De(equivalentDiameter(project.part->diameter_mm, project.wheel->diameter_mm,
                                  project.part->surface)) {}

    [[nodiscard]] ShopColumn column(const StageSums& sums, double time_s) const {
        ShopColumn c;
        c.time_s = time_s;
        c.removedVolume_mm3 = m_girth_mm * sums.removed_mm2;
        // Σ⟨P_z⟩·ℓ/b turns, P_z/b = k_t·a + μ·k_r·√a
        c.energy_j = m_wheelSpeed_m_s * m_turn_s
                     * (m_law.kt * sums.removed_mm2 + m_law.mu * m_law.kr * sums.rootLength_mm15);
        c.depth_mm = sums.depth_mm;
        const double a = sums.depth_mm.value;
        c.removalRate_mm2_s = removalRate(a);
        c.equivalentChip_um = removalRate(a) / m_wheelSpeed_m_s; // mm²/s over m/s
        c.aggressiveness =
            1e6 * workSpeed() / (m_wheelSpeed_m_s * units::mmPerM) * std::sqrt(a / m_De);
        if (sums.length_mm > 0) {
            c.meanRemovalRate_mm2_s = removalRate(sums.removed_mm2 / sums.length_mm);
            c.meanPower_w = c.energy_j / time_s;
        }
        if (c.removedVolume_mm3 > 0) {
            c.energy_j_mm3 = c.energy_j / c.removedVolume_mm3;
        }
        c.power_w = sums.power_w;
        c.normalForce_n = sums.normalForce_n;
        return c;
    }

private:
    [[nodiscard]] double workSpeed() const { return m_girth_mm / m_turn_s; } // V_d [mm/s]
    /// Q'_w = π·d·a·n.
    [[nodiscard]] double removalRate(double a) const { return workSpeed() * a; }

    ForceLaw m_law;
    double m_turn_s; ///< time of a revolution of the work
    double m_girth_mm;
    double m_wheelSpeed_m_s;
    double m_De;
};

std::optional<double> overlap(const Project& project, std::size_t stage) {
    const StageFeed* const axial = project.operation->axial();
    const auto axialFeed = axial ? project.cycle->stages[stage].*axial->value : std::nullopt;
    return axialFeed && *axialFeed > 0 ? std::optional(overlapOf(project, *axialFeed))
                                       : std::nullopt;
}

/// Empty for a stage without removal.
std::optional<std::string> peakPlace(const Peak& peak) {
    return peak.value > 0 ? std::optional(placeText(peak.at)) : std::nullopt;
}

constexpr Output<ShopColumn> shopColumnRows[] = {
    {{.label = SPARKOUT_NOOP("Output", "Double strokes"),
      .ofRevolutions = SPARKOUT_NOOP("Output", "Revolutions"),
      .hint = SPARKOUT_NOOP("Output", "Number completed in the stage.")},
     [](const ShopColumn& c) { return std::int64_t{c.count}; }},
    {{.key = "grinding_time_min",
      .label = SPARKOUT_NOOP("Output", "Time"),
      .unit = "min",
      .hint = SPARKOUT_NOOP("Output", "Machining time of the stage.")},
     [](const ShopColumn& c) { return c.time_s / units::secondsPerMinute; }},
    {{.key = "largest_depth_um",
      .label = SPARKOUT_NOOP("Output", "Maximum actual feed"),
      .unit = "µm",
      .detail = true},
     [](const ShopColumn& c) { return c.depth_mm.value * units::umPerMm; }},
    {{.key = "largest_depth_where", .detail = true},
     [](const ShopColumn& c) { return peakPlace(c.depth_mm); }},
    {{.key = "removal_rate_mm3_mm_s",
      .label = SPARKOUT_NOOP("Output", "Q′w"),
      .unit = "mm³/(mm·s)",
      .hint = SPARKOUT_NOOP(
          "Output", "Specific removal rate Q′_w = π·d·n·a/60: volume removed in a second by each "
                    "millimetre of the width that cuts, at the maximum actual feed a of the stage. "
                    "No band holds for every wheel: compare with cycles known to be good.")},
     [](const ShopColumn& c) { return c.removalRate_mm2_s; }},
    {{.key = "mean_removal_rate_mm3_mm_s",
      .label = SPARKOUT_NOOP("Output", "Mean Q′w"),
      .brief = SPARKOUT_NOOP("Output", "   mean"),
      .unit = "mm³/(mm·s)",
      .hint = SPARKOUT_NOOP("Output", "The specific removal rate at the mean actual feed of all "
                                      "passes of the stage, including those that remove nothing.")},
     [](const ShopColumn& c) { return c.meanRemovalRate_mm2_s; }},
    {{.key = "equivalent_chip_um",
      .label = SPARKOUT_NOOP("Output", "heq"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP(
          "Output",
          "Equivalent chip thickness h_eq = Q′_w/V_k, at the maximum actual feed of the stage: the "
          "layer of metal that leaves at the wheel's speed. Forces and roughness rise with it. No "
          "band holds for every wheel: compare with cycles known to be good.")},
     [](const ShopColumn& c) { return c.equivalentChip_um; }},
    {{.key = "aggressiveness",
      .label = SPARKOUT_NOOP("Output", "Aggressiveness"),
      .hint = SPARKOUT_NOOP(
          "Output",
          "Aggressiveness 10⁶·(V_d/V_k)·√(a/D_e), at the maximum actual feed of the stage: how "
          "hard the contact loads a grain, for wheels of any size. Large, the grains break out; "
          "small, they rub. No band holds for every wheel: compare with cycles known to be good.")},
     [](const ShopColumn& c) { return c.aggressiveness; }},
    {{.key = "overlap_ratio",
      .label = SPARKOUT_NOOP("Output", "Overlap B/s"),
      .hint =
          SPARKOUT_NOOP("Output", "Overlap ratio B/s_ax, s_ax = S_ax/n: how many revolutions a "
                                  "place of the surface is under the wheel in one stroke. Below 1 "
                                  "strips stay unground. For the cycle: the least of its stages."),
      .sparse = true},
     [](const ShopColumn& c) { return c.overlap; },
     [](const ShopColumn& c) { return c.overlapBand(); }},
    {{.key = "specific_energy_j_mm3",
      .label = SPARKOUT_NOOP("Output", "Energy"),
      .unit = "J/mm³",
      .hint =
          SPARKOUT_NOOP("Output", "Specific energy: ∫P_z·V_k dt over the volume removed. Plausible "
                                  "for steel: 20…120 J/mm³. A dull wheel needs more; so does "
                                  "spark-out, where the wheel rubs more than it cuts.")},
     [](const ShopColumn& c) { return c.energy_j_mm3; },
     [](const ShopColumn& c) { return c.specificEnergyBand(); }},
    {{.key = "specific_energy_plausible", .detail = true},
     [](const ShopColumn& c) {
         const BandSide band = c.specificEnergyBand();
         return band == BandSide::none ? std::nullopt : std::optional(band == BandSide::inside);
     }},
    {{.key = "peak_power_w",
      .label = SPARKOUT_NOOP("Output", "Maximum power"),
      .brief = SPARKOUT_NOOP("Output", "Power"),
      .unit = "W",
      .shownUnit = "kW",
      .shownFactor = 1 / units::wPerKw,
      .hint = SPARKOUT_NOOP("Output", "Maximum wheel power P_z·V_k of any pass of the stage.")},
     [](const ShopColumn& c) { return c.power_w.value; }},
    {{.key = "peak_power_where", .detail = true},
     [](const ShopColumn& c) { return peakPlace(c.power_w); }},
    {{.key = "mean_power_w",
      .label = SPARKOUT_NOOP("Output", "Mean power"),
      .brief = SPARKOUT_NOOP("Output", "   mean"),
      .unit = "W",
      .shownUnit = "kW",
      .shownFactor = 1 / units::wPerKw,
      .hint = SPARKOUT_NOOP(
          "Output", "Mean wheel power: the energy over the machining time of the stage, in all of "
                    "which the wheel grinds: plunging, dwells and strokes of the table.")},
     [](const ShopColumn& c) { return c.meanPower_w; }},
    {{.key = "peak_normal_force_n",
      .label = SPARKOUT_NOOP("Output", "Maximum force Py"),
      .brief = SPARKOUT_NOOP("Output", "Force Py"),
      .unit = "N",
      .hint = SPARKOUT_NOOP("Output", "Maximum normal force P_y of any pass of the stage.")},
     [](const ShopColumn& c) { return c.normalForce_n.value; }},
    {{.key = "peak_normal_force_where", .detail = true},
     [](const ShopColumn& c) { return peakPlace(c.normalForce_n); }},
    {{.key = "removed_volume_mm3",
      .label = SPARKOUT_NOOP("Output", "Volume removed"),
      .unit = "mm³",
      .detail = true},
     [](const ShopColumn& c) { return c.removedVolume_mm3; }},
    {{.key = "energy_j",
      .label = SPARKOUT_NOOP("Output", "Total energy"),
      .unit = "J",
      .shownUnit = "kJ",
      .shownFactor = 1 / units::jPerKj,
      .detail = true},
     [](const ShopColumn& c) { return c.energy_j; }},
};

constexpr Output<ShopNumbers> shopRows[] = {
    {{.key = "wheel_speed_rpm",
      .label = SPARKOUT_NOOP("Output", "Wheel speed"),
      .unit = "rev/min",
      .detail = true},
     [](const ShopNumbers& shop) { return shop.wheelSpeed_rpm; }},
    {{.key = "rotation_ratio",
      .label = SPARKOUT_NOOP("Output", "Rotation ratio"),
      .hint =
          SPARKOUT_NOOP("Output", "Wheel rev/min to work rev/min. Within 0.05 of a whole number "
                                  "the waves of a wheel out of true print onto one another: over "
                                  "ten revolutions they shift by less than half of their length.")},
     [](const ShopNumbers& shop) { return shop.rotationRatio; },
     [](const ShopNumbers& shop) {
         return shop.ratioNearInteger() ? BandSide::above : BandSide::inside;
     }},
    {{.key = "rotation_ratio_near_integer", .detail = true},
     [](const ShopNumbers& shop) { return shop.ratioNearInteger(); }},
};

// The hints above contain these numbers.
static_assert(leastSpecificEnergy_j_mm3 == 20 && mostSpecificEnergy_j_mm3 == 120
              && nearRatio == 0.05);

} // namespace

BandSide ShopColumn::specificEnergyBand() const {
    if (!energy_j_mm3) {
        return BandSide::none;
    }
    return *energy_j_mm3 < leastSpecificEnergy_j_mm3  ? BandSide::below
           : *energy_j_mm3 > mostSpecificEnergy_j_mm3 ? BandSide::above
                                                      : BandSide::inside;
}

BandSide ShopColumn::overlapBand() const {
    return !overlap ? BandSide::none : leavesStrips(*overlap) ? BandSide::below : BandSide::inside;
}

double distanceFromWhole(double rotationRatio) {
    return std::abs(rotationRatio - std::max(std::round(rotationRatio), 1.0));
}

bool ShopNumbers::ratioNearInteger() const {
    return distanceFromWhole(rotationRatio) <= nearRatio;
}

ShopNumbers shopNumbers(const SimulationResult& result) {
    const Project& project = result.project;
    const Shop shop(project);
    ShopNumbers numbers;
    StageSums all;
    std::optional<double> least;
    for (std::size_t z = 0; z < result.sumsByStage.size(); ++z) {
        const StageSums& sums = result.sumsByStage[z];
        ShopColumn column = shop.column(sums, result.timeByStage_s[z]);
        column.count = result.countsByStage[z];
        column.overlap = overlap(project, z);
        if (column.overlap && sums.length_mm > 0) {
            least = std::min(least.value_or(*column.overlap), *column.overlap);
        }
        all = add(all, sums);
        numbers.stages.push_back(column);
    }
    numbers.cycle = shop.column(all, result.time_s);
    numbers.cycle.count = result.cycleCount;
    numbers.cycle.overlap = least;
    numbers.wheelSpeed_rpm = wheelSpeed_rpm(project);
    numbers.rotationRatio = numbers.wheelSpeed_rpm / project.machine->work_speed_rpm;
    return numbers;
}

double removedVolume_mm3(const SimulationResult& result) {
    double removed_mm2 = 0;
    for (const StageSums& sums : result.sumsByStage) {
        removed_mm2 += sums.removed_mm2;
    }
    return std::numbers::pi * result.project.part->diameter_mm * removed_mm2;
}

std::span<const Output<ShopColumn>> shopColumnOutputs() {
    return shopColumnRows;
}

std::span<const Output<ShopNumbers>> shopOutputs() {
    return shopRows;
}

} // namespace sparkout
