// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/cycle_constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/reference_simulation.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

/// What differs between the engine and the second implementation, in words.
namespace sparkout::reference {

inline std::string statusName(RunStatus status) {
    switch (status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize: return "cannot_reach_size";
    case RunStatus::tooLong: return "too_long";
    case RunStatus::notSolved: return "not_solved";
    case RunStatus::groundAway: return "ground_away";
    case RunStatus::stopped:
    case RunStatus::refused: break;
    }
    return "stopped";
}

/// What differs among the stages' sums. Depths of some tenths are rounded to 1e-16 mm or so; a pass
/// that finds no more than that removes it in one engine and not in the other, so each sum may
/// differ by what such passes come to.
inline QString stageDifference(const SimulationResult& engine, const Result& second) {
    constexpr double depth = 1e-16; // [mm]
    const Project& project = engine.project;
    const ShopNumbers shop = shopNumbers(engine);
    const double turns_s = project.machine->work_speed_rpm / 60;
    const double rate = std::numbers::pi * project.part->diameter_mm * turns_s * depth; // [mm²/s]
    const double force = fixtures::Law(project).force(1, depth);                        // [N/mm]
    const double power = force * project.machine->wheel_speed_m_s; // P_z < P_y [W/mm]
    const double B = project.wheel->width_mm;
    if (shop.stages.size() != second.stages.size()) {
        return "number of stages";
    }
    for (std::size_t z = 0; z < second.stages.size(); ++z) {
        const ShopColumn& stage = shop.stages[z];
        const StageSums& other = second.stages[z];
        const double l = other.ground_mm;
        const double meanRate = l > 0 ? other.volume_mm3 / l * turns_s : 0;
        const std::tuple<const char*, double, double, double> pairs[] = {
            {"volume", stage.removedVolume_mm3, other.volume_mm3, rate / turns_s * l},
            {"energy", stage.energy_j, other.energy_j, power / turns_s * l},
            {"grinding time", stage.time_s / 60, other.grinding_min, 0},
            {"largest depth", stage.depth_mm.value, other.largest_depth_mm, depth},
            {"normal force", stage.normalForce_n.value, other.peak_normal_force_n, force * B},
            {"power", stage.power_w.value, other.peak_power_w, power * B},
            {"mean removal rate", stage.meanRemovalRate_mm2_s, meanRate, rate}};
        for (const auto& [what, a, b, absolute] : pairs) {
            if (!fixtures::within(a, b, absolute + 1e-9 * b)) {
                return QString("stage %1 %2: engine %3, reference %4")
                    .arg(z + 1)
                    .arg(what)
                    .arg(a, 0, 'g', 17)
                    .arg(b, 0, 'g', 17);
            }
        }
    }
    return {};
}

/// What differs among the limits of practice.
inline QString practiceDifference(const SimulationResult& engine, const Result& second) {
    ConstraintResults found;
    evaluateOverlap(ConstraintKind::overlap, {engine, {}}, found);
    evaluateOverlap(ConstraintKind::leastOverlap, {engine, {}}, found);
    evaluateOverlap(ConstraintKind::leastOverlapLast, {engine, {}}, found);
    std::ranges::stable_sort(found, {}, &ConstraintResult::stage);
    evaluateLeastSteps(ConstraintKind::leastSteps, {engine, {}}, found);
    if (found.size() != second.practice.size()) {
        return "number of limits of practice";
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const ConstraintResult& a = found[i];
        const Practice& b = second.practice[i];
        if (requirementOf(a.kind).key != b.name || a.stage != b.stage || a.holds != b.holds
            || a.limit != b.least || !fixtures::close(a.value, b.value, 1e-12)) {
            return QString("%1 of stage %2").arg(b.name.c_str()).arg(b.stage);
        }
    }
    return {};
}

/// What differs, in words; empty when nothing does.
inline QString difference(const SimulationResult& engine, const Result& second,
                          double diameter_mm) {
    const auto differs = [](const char* what, double a, double b) {
        return QString("%1: engine %2, reference %3")
            .arg(what)
            .arg(a, 0, 'g', 17)
            .arg(b, 0, 'g', 17);
    };
    if (statusName(engine.status) != second.status) {
        return QString("status: engine %1, reference %2")
            .arg(statusName(engine.status).c_str(), second.status.c_str());
    }
    if (engine.cycleCount != second.passes) {
        return differs("count", engine.cycleCount, static_cast<double>(second.passes));
    }
    if (!std::equal(engine.countsByStage.begin(), engine.countsByStage.end(),
                    second.passes_by_stage.begin(), second.passes_by_stage.end())) {
        return "counts by stage";
    }
    // Times are sums of at most some 10,000 durations, or of so many that each one's rounding of
    // ε/2 comes to more.
    const double rounding =
        std::max(1e-12, fixtures::epsilon / 2 * static_cast<double>(second.passes));
    if (!fixtures::close(engine.time_s / 60, second.time_min, rounding)) {
        return differs("time", engine.time_s / 60, second.time_min);
    }
    if (!fixtures::close(engine.peakNormalForce_n, second.peak_normal_force_n, 1e-9)) {
        return differs("peak force", engine.peakNormalForce_n, second.peak_normal_force_n);
    }
    if (!fixtures::close(engine.peakPower_w, second.peak_power_w, 1e-9)) {
        return differs("peak power", engine.peakPower_w, second.peak_power_w);
    }
    if (const QString stage = stageDifference(engine, second); !stage.isEmpty()) {
        return stage;
    }
    if (const QString practice = practiceDifference(engine, second); !practice.isEmpty()) {
        return practice;
    }
    if (engine.sections.size() != second.places.size()) {
        return "number of sections";
    }
    constexpr double um = 1e-6; // the agreement the vectors' page asks for
    for (std::size_t i = 0; i < second.places.size(); ++i) {
        const SectionResult& section = engine.sections[i];
        const Place& place = second.places[i];
        const std::pair<double, double> lengths[] = {
            {section.diameterDeviationMin_mm, place.diameter_deviation_min_um},
            {section.diameterDeviationMax_mm, place.diameter_deviation_max_um},
            {section.radialRunout_mm, place.radial_runout_um}};
        for (const auto& [mm, expected] : lengths) {
            if (!fixtures::within(mm * 1000, expected, um)) {
                return differs("deviation or runout", mm * 1000, expected);
            }
        }
        if (section.radii_mm.size() != place.radii_um.size()) {
            return "number of radii";
        }
        for (std::size_t k = 0; k < place.radii_um.size(); ++k) {
            const double radius = (section.radii_mm[k] - diameter_mm / 2) * 1000;
            if (std::isnan(radius) && std::isnan(place.radii_um[k])) {
                continue; // both see a gap
            }
            if (!fixtures::within(radius, static_cast<double>(place.radii_um[k]), um)) {
                return QString("section %1 radius %2, ").arg(i).arg(k)
                       + differs("µm", radius, static_cast<double>(place.radii_um[k]));
            }
        }
    }
    return {};
}

} // namespace sparkout::reference
