// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/batch.h"
#include "core/project/gauge.h"
#include "core/project/material.h"
#include "core/project/operation.h"
#include "core/project/part.h"
#include "core/project/sweep.h"
#include "core/project/wheel.h"

namespace sparkout {

/// A kept run: what was run, when, by which engine, and its summary. Never changed again.
struct KeptRun {
    std::string name;
    std::string when; ///< ISO 8601, UTC
    std::string engine_version;
    JsonText inputs;  ///< the project as run, without its runs
    JsonText summary; ///< counts, final radii, deviations, constraint values
    friend bool operator==(const KeptRun&, const KeptRun&) = default;
};

/// All inputs of one grinding cycle: what a project file holds. Members are named by their keys in
/// the file and carry the file's units.
struct Project {
    std::string title;
    std::string author;
    std::string notes;
    Operation operation;
    Part part;
    Material material;
    Wheel wheel;
    Machine machine;
    Gauge gauge;
    Cycle cycle;
    int sections = 4; ///< J, where the ground length has no zones
    bool sections_coupled = false;
    std::optional<Batch> batch;
    std::optional<Optimisation> optimisation;
    std::optional<Sweep> sweep;
    std::vector<KeptRun> runs;
};

/// How many zones or sections the ground length has.
[[nodiscard]] int placeCount(const Project& project);

template <>
const StructInfo& tableOf<KeptRun>();
template <>
const StructInfo& tableOf<Project>();

} // namespace sparkout
