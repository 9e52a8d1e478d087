// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/issue.h"

#include <optional>
#include <string_view>

namespace sparkout {

/// Why a text is not a state of a batch.
enum class StateFault {
    none,
    otherFormat,  ///< not a batch state
    tooDeep,      ///< nested deeper than limits::depth
    otherVersion, ///< a version that this program does not read
    changed,      ///< the checksum does not match the contents
    impossible    ///< contents no batch writes
};

/// Reads a state; without a result if no batch writes such a text.
struct ReadBatchState {
    StateFault fault = StateFault::none;
    std::optional<BatchResult> result;
    std::optional<Issue> issue; ///< the impossible value, at its JSON pointer

    explicit operator bool() const { return result.has_value(); }
};
[[nodiscard]] ReadBatchState readBatchState(std::string_view text);

} // namespace sparkout
