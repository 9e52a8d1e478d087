// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <vector>

namespace sparkout {

/// Time against margin: the cycles of a grid of which none is both as quick and of as great a least
/// relative margin as another. Margins within equalMargins count as as great.
struct TradeOff {
    std::vector<SearchSummary> cycles; ///< each with a best, the quickest first
    bool isWhole = false;              ///< there are no more
};

/// From the quickest cycle on, each next one is the quickest of those with a greater margin than
/// the last has. A cycle X that holds is none of these only if one of them is as good in both: let
/// F be the first of them whose margin is not below that of X. X has a greater margin than the one
/// before F, so the search that found F had X before it, and F is no slower.
///
/// @param quickest proved, of the same project and options
/// @param options of a method that proves; a stop keeps the cycles found until then
[[nodiscard]] TradeOff tradeOff(const Project& project, const SearchSummary& quickest,
                                SearchOptions options, std::size_t most);

} // namespace sparkout
