// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic system of a project on a stepped shaft, put together from its inputs by itself.
#pragma once

#include "core/process/compliance.h"
#include "tests/whole_project.h"

#include <utility>

namespace sparkout::fixtures {

inline Compliance shaftSystem(const Project& p) {
    constexpr double umPerMm = 1e3, mpaPerGpa = 1e3;
    ShaftModel model;
    for (const ShaftSegment& segment : p.part->shaft.segments) {
        model.segments.push_back({segment.length_mm, segment.diameter_mm});
    }
    for (const SteadyRest& rest : p.part->shaft.steady_rests) {
        model.rests.push_back({rest.position_mm, rest.stiffness_n_um * umPerMm});
    }
    model.youngsModulus_n_mm2 = p.part->shaft.youngs_modulus_gpa * mpaPerGpa;
    model.mounting = p.part->shaft.mounting;
    model.headstock_n_mm = p.machine->stiffness_n_um->headstock * umPerMm;
    model.tailstock_n_mm = p.machine->stiffness_n_um->tailstock * umPerMm;
    model.wheelHead_n_mm = p.machine->stiffness_n_um->wheel_head * umPerMm;
    return Compliance(std::move(model));
}

} // namespace sparkout::fixtures
