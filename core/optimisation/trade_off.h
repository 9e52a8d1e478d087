// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <vector>

namespace sparkout {

/// Time against margin: the cycles of a grid for which no other is both as quick and as far from
/// its limits. Margins within equalMargins count as equal.
struct TradeOff {
    std::vector<SearchSummary> cycles; ///< each with a best, the quickest first
    bool isComplete = false;           ///< there are no further cycles
};

/// Computes the trade-off: after the quickest cycle, each next one is the quickest with a greater
/// margin than the last. A feasible cycle X is missing only if one of these is as good in both: let
/// F be the first of them whose margin is not below that of X. X has a greater margin than the one
/// before F, so X was a candidate of the search that found F, and F takes at most as long.
///
/// @param quickest proved, for the same project and options
/// @param options with a proving method; a stop keeps the cycles found so far
[[nodiscard]] TradeOff tradeOff(const Project& project, const SearchSummary& quickest,
                                SearchOptions options, std::size_t most);

} // namespace sparkout
