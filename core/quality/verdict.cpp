// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/verdict.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/constraints.h"
#include "core/quality/roughness.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

/// Whether the gauge's last reading has metal beyond the drawing's limit.
bool endsOversize(const SimulationResult& result) {
    const Part& part = *result.project.part;
    const double deviation = result.gaugeReading_mm - part.diameter_mm;
    return part.surface == Surface::external
               ? deviation > part.upper_deviation_um / units::umPerMm + diameterSlack_mm
               : deviation < part.lower_deviation_um / units::umPerMm - diameterSlack_mm;
}

/// Rounded to hundredths of a micrometre.
Amount shortMm(double value) {
    return {std::round(value * 1e5) / 1e5, "mm"};
}

/// A spark-out that leaves stock which the deflection did not release.
void addSparkOut(const SimulationResult& result, Issues& found) {
    const auto& stages = result.project.cycle->stages;
    const Stage& last = stages.back();
    const bool leaves = last.sparkOutSteps() && last.stock_mm > 0;
    if (leaves && endsOversize(result)) {
        found.push_back({IssueCode::sparkOutLeaves, Severity::warning,
                         "/cycle/stages/" + std::to_string(stages.size() - 1) + "/stock_mm",
                         shortMm(result.remainingStock_mm), shortMm(last.stock_mm)});
    }
}

void addIdleStages(const SimulationResult& result, Issues& found) {
    const auto& stages = result.project.cycle->stages;
    for (std::size_t z = 0; z < stages.size(); ++z) {
        if (result.countsByStage[z] == 0 && stages[z].feeds()) {
            found.push_back({IssueCode::stageIdle, Severity::warning,
                             "/cycle/stages/" + std::to_string(z) + "/stock_mm", countOf(z + 1),
                             countOf(stages.size())});
        }
    }
}

void addDwells(const Project& project, Issues& found) {
    if (!project.operation->travels) {
        return;
    }
    constexpr double noticed = 0.02; // share of the dwell
    const Machine& machine = *project.machine;
    const std::pair<const char*, double> dwells[] = {{"entry", machine.dwell_entry_s},
                                                     {"exit", machine.dwell_exit_s}};
    for (const auto& [name, dwell_s] : dwells) {
        const double made_s = dwellRevolutions(dwell_s, machine.work_speed_rpm)
                              * units::secondsPerMinute / machine.work_speed_rpm;
        if (std::abs(made_s - dwell_s) > noticed * dwell_s) {
            found.push_back({IssueCode::dwellRounded, Severity::warning,
                             std::string("/machine/dwell_") + name + "_s", Amount{dwell_s, "s"},
                             Amount{std::round(made_s * 1e3) / 1e3, "s"}});
        }
    }
}

/// A factor of Ra that differs from that of the measured one.
void addRoughness(const Project& project, Issues& found) {
    const double given = project.wheel->roughness_factor;
    const std::optional<double> measured = factorOfMeasuredRa(project);
    if (const std::optional<double> computed_mm = computedAsMeasured(project);
        computed_mm && !measured) {
        const double most_um = mostRoughnessFactor * *computed_mm * units::umPerMm;
        found.push_back({IssueCode::unusualTogether, Severity::warning, "/wheel/measured_ra/ra_um",
                         Amount{project.wheel->measured_ra->ra_um, "µm"},
                         Bounds{.range = {0, most_um}, .field = "/wheel/roughness_factor"}});
    }
    if (!measured || given == 1) {
        return;
    }
    const auto shortFactor = [](double value) { return std::round(value * 100) / 100; };
    const Range range{*measured / roughnessSpread, *measured * roughnessSpread};
    if (!range.contains(given)) {
        found.push_back({IssueCode::unusualTogether, Severity::warning, "/wheel/roughness_factor",
                         Amount{given},
                         Bounds{.range = {shortFactor(range.low), shortFactor(range.high)},
                                .field = "/wheel/measured_ra/ra_um"}});
    }
}

} // namespace

Issues remarksOn(const SimulationResult& result) {
    if (result.status != RunStatus::completed || result.project.cycle->stages.empty()) {
        return {};
    }
    Issues found;
    addSparkOut(result, found);
    addIdleStages(result, found);
    addDwells(result.project, found);
    addRoughness(result.project, found);
    return found;
}

namespace {

constexpr double leastDivisor = 1e-12; ///< replaces 0 as a divisor

} // namespace

bool isClose(const ConstraintResult& constraint) {
    return constraint.holds && constraint.relativeMargin < closeMargin
           && requirementOf(constraint.kind).scope != ConstraintScope::setting;
}

bool isOpen(const ConstraintResult& constraint) {
    return constraint.holds && constraint.mostValue && *constraint.mostValue > constraint.limit;
}

bool isLowerBound(const ConstraintResult& constraint) {
    return constraint.holds && !constraint.knowsMachine;
}

MarginKnown marginKnown(const ConstraintResult& constraint) {
    if (!constraint.isWhole || isOpen(constraint)) {
        return MarginKnown::no;
    }
    if (!isLowerBound(constraint)) {
        return MarginKnown::exactly;
    }
    const int decimals = requirementOf(constraint.kind).digits.shown;
    return constraint.value < 0.5 * std::pow(10.0, -decimals) ? MarginKnown::no
                                                              : MarginKnown::atMost;
}

double statedMargin(const ConstraintResult& constraint) {
    return constraint.holds && constraint.mostValue ? constraint.limit - *constraint.mostValue
                                                    : constraint.margin;
}

bool isWorse(const ConstraintResult& first, const ConstraintResult& second) {
    const auto rank = [](const ConstraintResult& c) {
        return std::tuple(c.holds, c.holds || c.kind != ConstraintKind::overlap, !c.isWhole,
                          !isClose(c), c.relativeMargin);
    };
    return rank(first) < rank(second);
}

const ConstraintResult* worstRequirement(const std::vector<ConstraintResult>& constraints) {
    const auto worst = std::ranges::min_element(constraints, isWorse);
    return worst == constraints.end() ? nullptr : &*worst;
}

Light lightOf(const ConstraintResult& constraint) {
    if (!constraint.holds) {
        return Light::fails;
    }
    return isOpen(constraint) || isLowerBound(constraint) ? Light::undecided
           : isClose(constraint)                          ? Light::close
                                                          : Light::holds;
}

Light verdictOf(RunStatus status, const std::vector<ConstraintResult>& constraints) {
    Light light = status == RunStatus::completed ? Light::holds : Light::fails;
    for (const ConstraintResult& constraint : constraints) {
        light = std::max(light, lightOf(constraint));
    }
    return light;
}

double usageOf(const ConstraintResult& requirement) {
    const double limit = requirement.limit, value = requirement.value;
    if (requirementOf(requirement.kind).scope == ConstraintScope::setting) {
        return requirement.isLeast ? std::max(limit, 0.0) / std::max(value, leastDivisor)
                                   : value / std::max(limit, leastDivisor);
    }
    const bool isDecidedEstimate = requirement.mostValue && lightOf(requirement) == Light::holds;
    return isDecidedEstimate ? *requirement.mostValue / limit
                             : std::max(1 - requirement.relativeMargin, 0.0);
}

std::optional<double> placeInRange(const ConstraintResult& requirement) {
    if (!requirement.otherEnd) {
        return std::nullopt;
    }
    const auto [low, high] = std::minmax(requirement.limit, *requirement.otherEnd);
    const double value = std::clamp(requirement.value, low, high);
    if (high <= low) {
        return 0.5;
    }
    return low > 0 ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::optional<double> ratioInRange(const ConstraintResult& requirement) {
    const double limit = requirement.limit, value = requirement.value;
    const bool isRange = requirementOf(requirement.kind).source == LimitSource::range;
    return isRange && limit > 0 && value > 0
               ? std::optional(requirement.isLeast ? value / limit : limit / value)
               : std::nullopt;
}

int digitsOfRatio(double ratio) {
    constexpr int usual = 2, most = 6;
    int digits = usual;
    while (digits < most && ratio != 1 && std::abs(ratio - 1) < std::pow(10, 1 - digits)) {
        ++digits; // until a setting beyond or short of the end differs from it
    }
    return digits;
}

} // namespace sparkout
