// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The numbers among the inputs of a project, each at its path: members, the parts of a compliance
/// as given, and the number of spark-outs.
namespace sparkout {

struct NumberInput {
    std::string path; ///< "/cycle/stages/0/stock_mm"
    const Field* field = nullptr;
    Range allowed;               ///< refused outside
    bool integer = false;        ///< a whole number
    std::optional<double> value; ///< empty: not given
};

/// All inputs that a cycle of the project reads, in the order of the tables; without those of the
/// operation card, batch, search, sweep and kept runs.
[[nodiscard]] std::vector<NumberInput> numberInputs(const Project& project);

/// The input at a path; empty if there is none.
[[nodiscard]] std::optional<NumberInput> numberInput(const Project& project, std::string_view path);

/// Sets the input at a path to a value, rounded if need be; false if there is none.
bool setNumberInput(Project& project, std::string_view path, double value);

} // namespace sparkout
