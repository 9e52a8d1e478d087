// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// What a student hands in for a step; what its goal does not ask for is not given.
struct Answer {
    JsonText setup;               ///< as set, the text of a project file; {}: as the step begins
    std::optional<double> number; ///< predicted
    NumberRows curve;             ///< predicted, points [x, y] with rising x
    std::optional<std::vector<double>> order;  ///< of places from 0, the largest first
    std::optional<std::vector<double>> chosen; ///< options, from 1
    std::string text;

    /// Whether a set-up was handed in.
    [[nodiscard]] bool hasSetup() const { return setup != JsonText(); }
    friend bool operator==(const Answer&, const Answer&) = default;
};

template <>
const StructInfo& tableOf<Answer>();

} // namespace sparkout
