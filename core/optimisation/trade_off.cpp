// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/trade_off.h"

#include <utility>

namespace sparkout {

TradeOff tradeOff(const Project& project, const SearchSummary& quickest, SearchOptions options,
                  std::size_t most) {
    TradeOff found{{quickest}};
    while (found.cycles.size() < most) {
        const FeasibleCycle& last = *found.cycles.back().best;
        options.beyondMargin = last.leastRelativeMargin + equalMargins;
        options.quickest_us = last.time_us + 1; // it has the greatest margin of all with that time
        SearchSummary next = optimise(project, options);
        if (next.status != SearchStatus::proved) {
            found.isComplete = next.status == SearchStatus::infeasible;
            break;
        }
        found.cycles.push_back(std::move(next));
    }
    return found;
}

} // namespace sparkout
