// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/shop_numbers.h"

#include "core/process/force.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/ranges.h"
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

bool ShopNumbers::ratioNearInteger() const {
    const double whole = std::round(rotationRatio);
    return whole >= 1 && std::abs(rotationRatio - whole) <= nearRatio;
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

} // namespace sparkout
