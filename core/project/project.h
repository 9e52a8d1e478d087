// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/indirect.h"
#include "core/project/operation.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

// Forward declarations, since nearly every source includes this header; a user of a part of the
// project includes that part's header.
struct Batch;
struct CardEntries;
struct Cycle;
struct Gauge;
struct Machine;
struct Material;
struct Measured;
struct Optimisation;
struct Part;
struct Sweep;
struct Wheel;
extern template class Indirect<Batch>;
extern template class Indirect<CardEntries>;
extern template class Indirect<Cycle>;
extern template class Indirect<Gauge>;
extern template class Indirect<Machine>;
extern template class Indirect<Material>;
extern template class Indirect<Optimisation>;
extern template class Indirect<Part>;
extern template class Indirect<Sweep>;
extern template class Indirect<Wheel>;
extern template class OptionalShared<Measured>;

/// A kept run: its inputs, time, engine and summary. It is never changed.
struct KeptRun {
    std::string name;
    std::string when; ///< ISO 8601, UTC
    std::string engine_version;
    JsonText inputs;  ///< the project as run, without its runs
    JsonText summary; ///< counts, final radii, deviations, constraint values
    friend bool operator==(const KeptRun&, const KeptRun&) = default;
};

/// All inputs of one grinding cycle: the contents of a project file. Members are named by their
/// keys in the file and carry the file's units.
struct Project {
    std::string title;
    std::string author;
    std::string notes;
    std::string coolant; ///< description in words
    Operation operation;
    Indirect<Part> part;
    Indirect<Material> material;
    Indirect<Wheel> wheel;
    Indirect<Machine> machine;
    Indirect<Gauge> gauge;
    Indirect<Cycle> cycle;
    int sections = 4; ///< J, if the ground length has no zones
    bool sections_coupled = false;
    int zone_sections = 1; ///< number of sections in each zone
    // Requirements of shop practice; not given: not required.
    std::optional<double> least_overlap;      ///< B·n/S_ax of every stage
    std::optional<double> least_overlap_last; ///< B·n/S_ax of the last stage
    std::optional<int> least_steps; ///< double strokes or revolutions of a stage with stock
    Indirect<CardEntries> card;
    OptionalIndirect<Batch> batch;
    OptionalIndirect<Optimisation> optimisation;
    OptionalIndirect<Sweep> sweep;
    OptionalShared<Measured> measured;
    std::vector<KeptRun> runs;
};

/// The number of zones or sections of the ground length.
[[nodiscard]] int placeCount(const Project& project);

/// The number of sections of all zones, in addition to the zones' middles; 0 where each zone is its
/// middle.
[[nodiscard]] int zoneSectionCount(const Project& project);

template <>
const StructInfo& tableOf<KeptRun>();
template <>
const StructInfo& tableOf<Project>();

} // namespace sparkout
