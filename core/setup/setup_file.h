// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/setup/setup.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// The file of a set-up: version 1 for a single surface, see project_file.h; version 2 for several.
namespace sparkout {

struct ReadSetup {
    std::optional<Setup> setup; ///< given without errors
    /// Given if every value was read and is in its range, but some of its projects are unfinished,
    /// like that of ReadResult.
    std::optional<Setup> unfinished;
    Issues issues; ///< errors, or warnings with a set-up
};

/// Reads and validates a file of either version. Returns all faults at once; a fault of a shared
/// value is listed once.
[[nodiscard]] ReadSetup readSetup(std::string_view text, const std::stop_token& stop = {});

/// The text of a set-up: equal set-ups give equal bytes; for a single surface without name, times
/// and wear that of its project.
[[nodiscard]] std::string writeSetup(const Setup& setup);

/// Whether two set-ups have the same values.
[[nodiscard]] bool sameSetup(const Setup& a, const Setup& b);

} // namespace sparkout
