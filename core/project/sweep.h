// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/project/project.h"

#include <string>
#include <vector>

namespace sparkout {

/// The faults that prevent the sweep of a project: inputs that are not its numbers, ranges beyond
/// what an input allows. Empty without a sweep. A single cycle does not need them.
[[nodiscard]] Issues sweepFaults(const Project& project);

enum class SweepSpacing { linear, logarithmic };

/// An input that a sweep varies, in the unit of that input.
struct SweepAxis {
    std::string input; ///< path of the input, "/wheel/dullness"
    double from = 0;
    double to = 0;
    int points = 21;
    SweepSpacing spacing = SweepSpacing::linear;
};

/// The varied inputs and their ranges: one for curves, two for a map.
struct Sweep {
    std::vector<SweepAxis> inputs;
};

template <>
std::span<const Choice> choicesOf<SweepSpacing>();
template <>
const StructInfo& tableOf<SweepAxis>();
template <>
const StructInfo& tableOf<Sweep>();

} // namespace sparkout
