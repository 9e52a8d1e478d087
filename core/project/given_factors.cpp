// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/given_factors.h"

#include "core/project/batch.h"
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
    case FactorKind::compliance: break;
    }
    return {1e-3, 1e3}; // a factor on γ: between a thousandth and a thousand times
}

/// Of the inputs that say how zones scatter.
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
                    each.kind, {}, allowed, static_cast<int>(place), project.operation->hasZones};
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

const char* factorLabel(const GivenFactor& factor) {
    return factor.place < 0
               ? tableOf<Factors>().fields[static_cast<std::size_t>(factor.kind)].label
               : tableOf<Batch>()
                     .find(std::ranges::find(zoneRows, factor.kind, &ZoneRows::kind)->key)
                     ->label;
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
