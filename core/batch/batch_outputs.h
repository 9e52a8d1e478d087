// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/result.h"

#include <span>
#include <vector>

namespace sparkout {

/// The figures of a characteristic, and what kind of batch they are of.
struct CharacteristicFigures {
    const CharacteristicSummary* of = nullptr;
    bool isSample = true; ///< not of corners, of which only extremes and counts are stated
    bool drifts = false;
};

/// Those of a summary, which must outlive them.
[[nodiscard]] std::vector<CharacteristicFigures> figuresOf(const BatchSummary& summary);

[[nodiscard]] std::span<const Output<CharacteristicFigures>> characteristicOutputs();

} // namespace sparkout
