// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/study/search.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sparkout {

[[nodiscard]] std::span<const Output<SearchOutcome>> searchOutputs();

/// Returns the cost of a part ground with the answer; empty without an answer or without rates.
[[nodiscard]] std::optional<double> costOfAnswer(const SearchOutcome& outcome);

/// A machine setting that the search was free to choose, with its value in a cycle found.
struct FreeSetting {
    const char* key; ///< key in Machine
    double value;
};
[[nodiscard]] std::vector<FreeSetting> freeSettings(const Project& searched,
                                                    const MachineSettings& found);

/// Returns the object of `optimize --json`; its keys are fixed.
[[nodiscard]] std::string searchJson(const SearchOutcome& outcome);

} // namespace sparkout
