// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/refine_answer.h"

#include "core/optimisation/robust.h"

namespace sparkout {

RefineSummary refineAnswer(const GridAnswer& answer, const std::stop_token& stop) {
    RefineOptions options;
    options.stop = stop;
    if (answer.robust) {
        options.everyStageSteps = true;
        options.scenarios = answer.robust->scenarios;
        options.source = undecidedScenarios(answer.asked, stop);
        options.candidates = answer.robust->candidates;
        options.asksCapability = answer.robust->isCapable;
    }
    return refine(answer.best, answer.cycle, options);
}

} // namespace sparkout
