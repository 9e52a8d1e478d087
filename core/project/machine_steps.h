// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace sparkout {

struct Project;

/// The values that a control of the machine takes: low + k·step, no higher than high.
struct MachineSteps {
    double low = 0, high = std::numeric_limits<double>::infinity();
    double step = 0; ///< above 0

    [[nodiscard]] double nearest(double value) const; ///< it may lie beyond the ends
    /// The value so many steps up or down, within the ends. A negative feed, which draws the wheel
    /// back, is stepped by its size.
    [[nodiscard]] double stepped(double value, int steps) const;
};

/// What the machine states for an input, by the input's path: [lowest, highest, step]. Null where
/// it states nothing.
[[nodiscard]] const std::vector<double>* machineRange(const Project& project,
                                                      std::string_view path);
/// The values that an input takes on the machine. The stock of a stage goes by the steps of the
/// radial feed per double stroke, which are those of the wheel slide's position. Nothing where the
/// machine states no step.
[[nodiscard]] std::optional<MachineSteps> machineSteps(const Project& project,
                                                       std::string_view path);
/// A value of an input so many of these steps up or down; nothing where there are none.
[[nodiscard]] std::optional<double> steppedOnMachine(const Project& project, std::string_view path,
                                                     double value, int steps);

} // namespace sparkout
