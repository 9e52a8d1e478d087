// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string>
#include <vector>

namespace sparkout {

enum class SweepSpacing { linear, logarithmic };

/// An input that a sweep varies, in the unit of that input.
struct SweepAxis {
    std::string input; ///< its path, "/wheel/dullness"
    double from = 0;
    double to = 0;
    int points = 21;
    SweepSpacing spacing = SweepSpacing::linear;
};

/// Which inputs are varied to see what they do: one for curves, two for a map.
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
