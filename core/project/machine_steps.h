// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace sparkout {

struct Project;

/// The values that a control of the machine can be set to: low + k·step, up to high.
struct MachineSteps {
    double low = 0, high = std::numeric_limits<double>::infinity();
    double step = 0; ///< positive

    [[nodiscard]] double nearest(double value) const; ///< the value may lie beyond the ends
    /// The value that number of steps up or down, within the ends. A negative feed, which retracts
    /// the wheel, is stepped by its size.
    [[nodiscard]] double stepped(double value, int steps) const;
};

/// The machine's range for an input, by the input's path: [lowest, highest, step]; null if it has
/// none.
[[nodiscard]] const std::vector<double>* machineRange(const Project& project,
                                                      std::string_view path);
/// The values that an input can take on the machine. The stock of a stage follows the steps of the
/// radial feed per double stroke, which are those of the wheel slide's position. Empty where the
/// machine states no step.
[[nodiscard]] std::optional<MachineSteps> machineSteps(const Project& project,
                                                       std::string_view path);
/// The value of an input that number of machine steps up or down; empty without steps.
[[nodiscard]] std::optional<double> steppedOnMachine(const Project& project, std::string_view path,
                                                     double value, int steps);

} // namespace sparkout
