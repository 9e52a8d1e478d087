// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/issue.h"

#include <optional>
#include <string_view>

namespace sparkout {

/// Why a text is no state of a batch.
enum class StateFault {
    none,
    otherFormat,  ///< not a batch state
    tooDeep,      ///< nested deeper than limits::depth, as no state is
    otherVersion, ///< a version that this program does not read
    changed,      ///< the checksum does not match the contents
    impossible    ///< contents no batch writes
};

/// Reads it back; without a result when no batch writes such a text.
struct ReadBatchState {
    StateFault fault = StateFault::none;
    std::optional<BatchResult> result;
    std::optional<Issue> issue; ///< the impossible value, at its JSON pointer

    explicit operator bool() const { return result.has_value(); }
};
[[nodiscard]] ReadBatchState readBatchState(std::string_view text);

} // namespace sparkout
