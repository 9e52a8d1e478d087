// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/study/search.h"

#include <optional>
#include <span>
#include <vector>

namespace sparkout {

[[nodiscard]] std::span<const Output<SearchOutcome>> searchOutputs();

/// What a part costs that is ground by the answer; nothing: no answer, or no rates.
[[nodiscard]] std::optional<double> costOfAnswer(const SearchOutcome& outcome);

/// A setting of the machine that was free to choose, and what it is in a cycle found.
struct FreeSetting {
    const char* key; ///< of Machine
    double value;
};
[[nodiscard]] std::vector<FreeSetting> freeSettings(const Project& searched,
                                                    const MachineSettings& found);

} // namespace sparkout
