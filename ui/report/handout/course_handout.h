// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"

#include <functional>
#include <set>

namespace sparkout::report {

/// The options for a teacher.
struct HandoutOptions {
    StepWish step = usualStep(); ///< of the matching steps the one with the deepest cut
    std::set<HandoutView> views{HandoutView::feeds, HandoutView::cycle, HandoutView::profiles};
    bool answers = true; ///< the key, on a separate last page
};

/// The course hand-out: a step of the cycle worked out formula by formula with its numbers,
/// figures, and questions with answers computed by the engine. Requires a valid run. `breathe` is
/// called between figures and runs, so that a window stays responsive.
[[nodiscard]] Report courseHandout(
    const OutcomePtr& outcome, const QString& file, const QDate& date,
    const HandoutOptions& options, const std::function<void()>& breathe = [] {});

} // namespace sparkout::report
