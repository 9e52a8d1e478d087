// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/usual_batch.h"

#include "core/batch/batch_run.h"
#include "core/process/force.h"
#include "core/project/gauge.h"
#include "core/project/iso286.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double gaugeSetEach_h = 1;   ///< time between two settings of the gauge
constexpr double usualHandling_s = 30; ///< handling time of a piece
constexpr double secondsPerHour = 3600;
constexpr double gaugeReach = 3; ///< standard deviations to which an error is truncated
constexpr double warmth_k = 2;   ///< standard deviation of a part's temperature at the gauge
constexpr double outsideOfPpk1 = 0.0027; ///< share of a normal law beyond 3 s
/// IT grade of the diameter before grinding; 9 for fine turning, 11 for coarse.
constexpr int turnedGrade = 10;
constexpr double mostOfStock = 1.0 / 3; ///< share of the stock that turning may take or leave

std::vector<double> sharesOf(double value, std::initializer_list<double> shares) {
    std::vector<double> values;
    for (const double share : shares) {
        values.push_back(share == 1 ? value : toTwoDigits(value * share));
    }
    return values;
}

Factor evenly(std::vector<double> ends) {
    Factor factor;
    factor.uniform = std::move(ends);
    return factor;
}

Factor growing(std::vector<double> ends, int parts) {
    Factor factor;
    factor.grows = std::move(ends);
    factor.parts_between_dressings = parts;
    return factor;
}

Factor normally(std::vector<double> normal, std::vector<double> within) {
    Factor factor;
    factor.normal = std::move(normal);
    factor.within = std::move(within);
    return factor;
}

/// A normal factor with mean 0.
Factor aboutNothing(double deviation) {
    return normally({0, deviation}, {-gaugeReach * deviation, gaugeReach * deviation});
}

/// Half the range of the stock per side [mm]. The part is turned before it is ground: its diameter
/// scatters over a standard tolerance [ISO286], its radius by a quarter of that in each direction.
/// A small stock is left by a finer machining, a large one scatters at least by the usual share.
double halfRangeOfStock_mm(const Part& part) {
    const double stock_mm = part.stock_mm;
    const double side = part.surface == Surface::external ? 1 : -1;
    const double turned_mm = part.diameter_mm + side * 2 * stock_mm;
    const double field_um = standardTolerance(turned_mm, turnedGrade).value_or(0);
    const double turning_mm = std::min(field_um / units::umPerMm / 4, mostOfStock * stock_mm);
    return toTwoDigits(std::max(turning_mm, (mostUsualShare - 1) * stock_mm));
}

/// An even factor about a value, in whole nanometres.
Factor evenlyAbout(double value_mm, double half_mm) {
    constexpr double perMm = 1e6;
    const auto whole = [](double end_mm) { return std::round(end_mm * perMm) / perMm; };
    return evenly({whole(value_mm - half_mm), whole(value_mm + half_mm)});
}

/// The number of parts ground between two settings of the gauge.
int partsOfGauge(const Project& project) {
    Project alone = project;
    alone.batch.reset();
    const double piece_s = usualHandling_s + simulate(alone).time_s;
    const auto parts = static_cast<int>(std::lround(gaugeSetEach_h * secondsPerHour / piece_s));
    return std::max(2, parts); // for the two ends of the drift
}

/// Usual causes that apply to the project.
std::vector<FactorKind> usualKinds(const Project& project) {
    const Machine& machine = *project.machine;
    const Tolerance& asked = project.part->tolerance;
    const bool isRunoutAsked = asked.radial_runout_um || asked.total_runout_um;
    const bool isGauged = project.gauge->control == Control::gauge;
    const std::array causes{
        std::pair(FactorKind::stock, true),
        std::pair(FactorKind::runout, project.part->initial_runout_mm > 0),
        std::pair(FactorKind::dullness, dullnessOf(*project.wheel) > 0 && !hasThreshold(project)),
        std::pair(FactorKind::compliance, true),
        std::pair(FactorKind::machineForm,
                  isRunoutAsked && (machine.form || machine.geometric_runout_um > 0)),
        std::pair(FactorKind::wheelPhase, project.wheel->runout.has_value()),
        std::pair(FactorKind::gaugeError,
                  isGauged && machine.gauge_repeatability_um.value_or(0) > 0),
        std::pair(FactorKind::gaugeAge, isGauged && machine.gauge_drift_um_h.value_or(0) != 0),
        std::pair(FactorKind::partWarmer, isGauged)};
    std::vector<FactorKind> kinds;
    for (const auto& [kind, has] : causes) {
        if (has) {
            kinds.push_back(kind);
        }
    }
    return kinds;
}

std::optional<Factor>& lawIn(Project& project, FactorKind kind) {
    const Field& field = tableOf<Factors>().fields[static_cast<std::size_t>(kind)];
    return field.as<std::optional<Factor>>(&project.batch->factors);
}

} // namespace

double toTwoDigits(double value) {
    if (value == 0) {
        return 0;
    }
    const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    // Divides for steps below 1, so that 0.14 stays exact.
    return step < 1 ? std::round(value / step) / std::round(1 / step)
                    : std::round(value / step) * step;
}

Factor usualFactor(FactorKind kind, const Project& project) {
    switch (kind) {
    case FactorKind::stock:
        return evenlyAbout(project.part->stock_mm, halfRangeOfStock_mm(*project.part));
    case FactorKind::runout: {
        const double runout = project.part->initial_runout_mm;
        return runout > 0 ? normally(sharesOf(runout, {1, 0.25}), sharesOf(runout, {0.25, 2}))
                          : evenly({0, 0.01});
    }
    case FactorKind::dullness:
        return growing(sharesOf(dullnessOf(*project.wheel), {0.75, 1.5}),
                       usualPartsBetweenDressings);
    case FactorKind::wheelDiameter:
        return growing(sharesOf(project.wheel->diameter_mm, {1, 0.9}), usualPartsBetweenDressings);
    case FactorKind::flowStress: {
        const double stress = project.material->flow_stress_mpa;
        return normally(sharesOf(stress, {1, 0.05}), sharesOf(stress, {0.85, 1.15}));
    }
    case FactorKind::compliance: return evenly({0.9, 1.1});
    case FactorKind::machineForm: return normally({1, 0.3}, {0, 2});
    case FactorKind::runoutAt:
    case FactorKind::wheelPhase: return evenly({0, 360});
    case FactorKind::contactWidth:
        return evenly(
            sharesOf(project.operation->travels ? project.wheel->width_mm : project.part->length_mm,
                     {0.96, 1}));
    case FactorKind::gaugeError: return aboutNothing(1);
    case FactorKind::gaugeAge: return growing({0, gaugeSetEach_h}, partsOfGauge(project));
    case FactorKind::partWarmer: return aboutNothing(warmth_k);
    }
    return {};
}

Project withUsualBatch(Project project) {
    Batch usual;
    usual.most_outside_share = outsideOfPpk1;
    project.batch = usual;
    const std::vector<FactorKind> kinds = usualKinds(project);
    for (const FactorKind kind : kinds) {
        lawIn(project, kind) = usualFactor(kind, project);
    }
    if (checkBatch(project).empty()) {
        return project;
    }
    project.batch = std::move(usual); // keep only the factors with which every part is valid
    for (const FactorKind kind : kinds) {
        lawIn(project, kind) = usualFactor(kind, project);
        if (!checkBatch(project).empty()) {
            lawIn(project, kind).reset();
        }
    }
    return project;
}

} // namespace sparkout
