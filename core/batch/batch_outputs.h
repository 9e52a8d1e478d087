// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/result.h"

#include <span>
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

} // namespace sparkout
