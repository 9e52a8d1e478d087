// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/given_factors.h"

#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr double mostFormFactor = 100;
constexpr double mostGaugeError = 10; ///< standard deviations
constexpr double longestGaugeAge_h = 1000;

Range allowedValues(FactorKind kind, Operation operation) {
    switch (kind) {
    case FactorKind::stock: return tableOf<Part>().find("stock_mm")->hard;
    case FactorKind::runout: return tableOf<Part>().find("initial_runout_mm")->hard;
    case FactorKind::dullness: return tableOf<Wheel>().find("dullness")->hard;
    case FactorKind::wheelDiameter: return tableOf<Wheel>().find("diameter_mm")->hard;
    case FactorKind::flowStress: return tableOf<Material>().find("flow_stress_mpa")->hard;
    case FactorKind::contactWidth:
        return operation->travels ? tableOf<Wheel>().find("width_mm")->hard
                                  : tableOf<Part>().find("length_mm")->hard;
    case FactorKind::machineForm: return {0, mostFormFactor};
    case FactorKind::runoutAt: return tableOf<MachineForm>().find("runout_at_deg")->hard;
    case FactorKind::wheelPhase: return tableOf<WheelRunout>().find("phase_deg")->hard;
    case FactorKind::gaugeError: return {-mostGaugeError, mostGaugeError};
    case FactorKind::gaugeAge: return {0, longestGaugeAge_h};
    case FactorKind::partWarmer: return tableOf<Gauge>().find("part_warmer_k")->hard;
    case FactorKind::compliance: break;
    }
    return {1e-3, 1e3}; // a factor on γ: from a thousandth to a thousand
}

/// The inputs that describe the scatter of the zones.
struct ZoneRows {
    FactorKind kind;
    const char* key;
    NumberRows Batch::*rows;
};
constexpr std::array zoneRows{
    ZoneRows{FactorKind::stock, "zone_stock_mm", &Batch::zone_stock_mm},
    ZoneRows{FactorKind::runout, "zone_runout_mm", &Batch::zone_runout_mm},
    ZoneRows{FactorKind::compliance, "zone_compliance", &Batch::zone_compliance}};

std::vector<GivenFactor> ofZones(const Project& project, bool constant) {
    std::vector<GivenFactor> found;
    if (!project.batch) {
        return found;
    }
    for (const ZoneRows& each : zoneRows) {
        const NumberRows& ranges = (*project.batch).*each.rows;
        const Range allowed = tableOf<Batch>().find(each.key)->hard;
        for (std::size_t place = 0; ranges && place < ranges->size(); ++place) {
            const std::vector<double>& ends = (*ranges)[place];
            if (ends.size() == 2 && (ends[0] == ends[1]) == constant) {
                GivenFactor factor{
                    each.kind, {}, allowed, static_cast<int>(place), project.operation->travels};
                factor.law.uniform = ends;
                found.push_back(std::move(factor));
            }
        }
    }
    return found;
}

} // namespace

std::vector<GivenFactor> givenFactors(const Project& project) {
    std::vector<GivenFactor> given;
    const auto fields = tableOf<Factors>().fields;
    for (std::size_t i = 0; project.batch && i < fields.size(); ++i) {
        if (const void* law = fields[i].objectIn(&project.batch->factors)) {
            const auto kind = static_cast<FactorKind>(i);
            given.push_back(
                {kind, *static_cast<const Factor*>(law), allowedValues(kind, project.operation)});
            if (auto& measured = given.back().law.measured) {
                std::sort(measured->begin(), measured->end());
            }
        }
    }
    return given;
}

std::vector<GivenFactor> zoneFactors(const Project& project) {
    return ofZones(project, false);
}

std::vector<GivenFactor> zoneConstants(const Project& project) {
    return ofZones(project, true);
}

std::vector<GivenFactor> scatteredFactors(const Project& project) {
    std::vector<GivenFactor> all = givenFactors(project);
    for (GivenFactor& each : zoneFactors(project)) {
        all.push_back(std::move(each));
    }
    return all;
}

std::size_t corneredCount(const std::vector<GivenFactor>& factors) {
    return static_cast<std::size_t>(std::ranges::count_if(
        factors, [](const GivenFactor& each) { return !isOfReading(each.kind); }));
}

namespace {

/// Whether the project has the number that a factor multiplies.
bool hasWhatItMultiplies(FactorKind kind, const Project& project) {
    const Machine& machine = *project.machine;
    switch (kind) {
    case FactorKind::machineForm: return machine.form || machine.geometric_runout_um > 0;
    case FactorKind::gaugeError: return machine.gauge_repeatability_um.value_or(0) > 0;
    case FactorKind::gaugeAge: return machine.gauge_drift_um_h.value_or(0) != 0;
    default: return true;
    }
}

} // namespace

std::vector<FactorKind> notCounted(const Project& project) {
    const bool corners = project.batch && project.batch->scenarios == Scenarios::corners;
    const auto& stages = project.cycle->stages;
    const bool isRead = project.gauge->control == Control::gauge
                        || (!stages.empty() && stages.back().waitsForSize());
    const std::vector<GivenFactor> given = scatteredFactors(project);
    std::vector<FactorKind> left;
    const auto fields = tableOf<Factors>().fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto kind = static_cast<FactorKind>(i);
        const bool isGiven = std::ranges::find(given, kind, &GivenFactor::kind) != given.end();
        const bool isCounted =
            isGiven && hasWhatItMultiplies(kind, project) && !(corners && isOfReading(kind));
        const bool isUsual =
            fields[i].usual || isOfReading(kind) || kind == FactorKind::machineForm;
        if (isUsual && !isCounted && (isRead || !isOfReading(kind))) {
            left.push_back(kind);
        }
    }
    return left;
}

const char* factorLabel(const GivenFactor& factor) {
    return factor.place < 0
               ? factorLabel(factor.kind)
               : tableOf<Batch>()
                     .find(std::ranges::find(zoneRows, factor.kind, &ZoneRows::kind)->key)
                     ->label;
}

const char* factorLabel(FactorKind kind) {
    return tableOf<Factors>().fields[static_cast<std::size_t>(kind)].label;
}

std::string factorKey(const GivenFactor& factor) {
    if (factor.place < 0) {
        return factorKey(factor.kind);
    }
    constexpr std::array zones{"rz1", "nz", "rz2"};
    const auto row = std::ranges::find(zoneRows, factor.kind, &ZoneRows::kind);
    const auto place = static_cast<std::size_t>(factor.place);
    return std::string(row->key) + ' '
           + (factor.isOfZone && place < zones.size() ? std::string(zones[place])
                                                      : "section " + std::to_string(place));
}

const char* factorKey(FactorKind kind) {
    return tableOf<Factors>().fields[static_cast<std::size_t>(kind)].key;
}

} // namespace sparkout
