// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/sensitivity.h"

#include <optional>
#include <string>

namespace sparkout {

[[nodiscard]] const char* batchStatusKey(BatchStatus status); ///< "narrow_enough"

/// The object of `batch --json`; its named keys are fixed. "worst" is the part with the least
/// margin: the values of its factors and a project for `simulate`.
[[nodiscard]] std::string batchJson(const BatchResult& result,
                                    const std::optional<SobolIndices>& indices = {});

/// The CSV of `batch --csv`: a row for each characteristic of a zone or section.
[[nodiscard]] std::string batchCsv(const BatchResult& result);

} // namespace sparkout
