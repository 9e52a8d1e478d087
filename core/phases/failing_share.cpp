// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/failing_share.h"

namespace sparkout {

FailingShare failingShare(const PhaseDecision& decision,
                          const std::function<double(double)>& shareBelow) {
    const StockRange& range = decision.range;
    FailingShare shares{0, 1 - (shareBelow(range.to_mm) - shareBelow(range.from_mm))};
    for (const StockRange& each : decision.failingRanges()) {
        shares.failing += shareBelow(each.to_mm) - shareBelow(each.from_mm);
    }
    return shares;
}

} // namespace sparkout
