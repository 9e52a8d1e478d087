// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/failing_share.h"

#include <algorithm>

namespace sparkout {

FailingShare failingShare(const PhaseDecision& decision,
                          const std::function<double(double)>& shareBelow) {
    const StockRange& range = decision.range;
    FailingShare shares{0, 1 - (shareBelow(range.to_mm) - shareBelow(range.from_mm))};
    double counted_mm = range.from_mm;
    for (const FailingStocks& each : decision.failing) {
        const double from_mm = std::max(each.stocks.from_mm, counted_mm);
        if (each.stocks.to_mm > from_mm) {
            shares.failing += shareBelow(each.stocks.to_mm) - shareBelow(from_mm);
            counted_mm = each.stocks.to_mm;
        }
    }
    return shares;
}

} // namespace sparkout
