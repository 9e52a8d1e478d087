// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/judged_outcome.h"

#include <optional>

namespace sparkout {

Judgement judgementOf(const Outcome& outcome, const BatchOutcome* batch,
                      const std::stop_token& stop) {
    const bool hasBatch = batch && batch->ran();
    return judge(outcome.result, outcome.constraints, judgeStocks(outcome.result, stop),
                 hasBatch ? std::optional(judgeBatch(batch->result, batch->summary))
                          : std::nullopt);
}

} // namespace sparkout
