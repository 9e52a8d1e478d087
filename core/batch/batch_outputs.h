// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sparkout {

/// The figures of a characteristic and the kind of their batch.
struct CharacteristicFigures {
    const CharacteristicSummary* of = nullptr;
    bool isSample = true; ///< false: corners, for which only extremes and counts are reported
    bool drifts = false;
};

/// The figures of a summary, which must outlive them.
[[nodiscard]] std::vector<CharacteristicFigures> figuresOf(const BatchSummary& summary);

[[nodiscard]] std::span<const Output<CharacteristicFigures>> characteristicOutputs();

[[nodiscard]] const char* batchStatusKey(BatchStatus status); ///< "narrow_enough"

/// The object of `batch --json`; its named keys are fixed. "worst" is the part with the least
/// margin: the values of its factors and a project for `simulate`.
[[nodiscard]] std::string batchJson(const BatchResult& result,
                                    const std::optional<SobolIndices>& indices = {});

/// The CSV of `batch --csv`: a row for each characteristic of a zone or section.
[[nodiscard]] std::string batchCsv(const BatchResult& result);

} // namespace sparkout
