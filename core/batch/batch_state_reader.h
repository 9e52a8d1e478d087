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
    otherFormat,  ///< not of this kind at all
    tooDeep,      ///< nested deeper than limits::depth, as no state is
    otherVersion, ///< of a version that this one does not read
    changed,      ///< its checksum is not that of its contents
    impossible    ///< contents no batch writes
};

/// Reads it back; without a result when no batch writes such a text.
struct ReadBatchState {
    StateFault fault = StateFault::none;
    std::optional<BatchResult> result;
    std::optional<Issue> issue; ///< of an impossible one: what no batch writes, at its JSON pointer

    explicit operator bool() const { return result.has_value(); }
};
[[nodiscard]] ReadBatchState readBatchState(std::string_view text);

} // namespace sparkout
