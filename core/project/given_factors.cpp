// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/given_factors.h"

#include "core/project/batch.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <algorithm>

namespace sparkout {

namespace {

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
    case FactorKind::compliance: break;
    }
    return {1e-3, 1e3}; // a factor on γ: between a thousandth and a thousand times
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

const char* factorKey(FactorKind kind) {
    return tableOf<Factors>().fields[static_cast<std::size_t>(kind)].key;
}

} // namespace sparkout
