// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// A student's answer to a step; what its goal does not ask for is not given.
struct Answer {
    JsonText setup; ///< set-up as the text of a project file; {}: unchanged from the beginning of
                    ///< the step
    std::optional<double> number;              ///< predicted
    NumberRows curve;                          ///< predicted, points [x, y] with rising x
    std::optional<std::vector<double>> order;  ///< places counted from 0, the largest first
    std::optional<std::vector<double>> chosen; ///< options, from 1
    std::string text;

    /// Whether a set-up was handed in.
    [[nodiscard]] bool hasSetup() const { return setup != JsonText(); }
    friend bool operator==(const Answer&, const Answer&) = default;
};

template <>
const StructInfo& tableOf<Answer>();

} // namespace sparkout
