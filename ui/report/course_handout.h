// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/exercises.h"
#include "core/study/outcome.h"
#include "ui/report/format/report.h"

#include <QString>

#include <functional>
#include <optional>
#include <set>
#include <span>

namespace sparkout::report {

/// The step that the hand-out works out.
using HandoutStep = RecordedStep;

/// The requested step; unspecified members match any.
struct StepWish {
    std::optional<Zone> zone;
    std::optional<int> section, stage, count, step, revolution, radius;
};

/// The deepest cut of the roughing stage: the default step.
[[nodiscard]] inline StepWish usualStep() {
    StepWish wish;
    wish.stage = 1;
    return wish;
}

/// "27,nz,e1,r1,k9": the double stroke (plunge: the revolution), then in any order a zone or
/// section (rz1, nz, rz2, s0), a stage (z1), a step (e1), a revolution within it (r1), a radius
/// (k9). Empty if the text is invalid.
[[nodiscard]] std::optional<StepWish> readStepWish(const QString& text);

/// The matching visit with the deepest cut, the first of equal ones. Empty if none matches or none
/// was recorded.
[[nodiscard]] std::optional<HandoutStep> findStep(const Trajectory& trajectory,
                                                  const StepWish& wish = {});

/// The possible figures of the hand-out.
enum class HandoutView {
    feeds,    ///< feeds around the step, with E1…E5
    cycle,    ///< feeds over the whole cycle
    profiles, ///< cross-sections at the end
    limits,   ///< actual feed below its limits
    grid,     ///< of dynamic programming
};
struct HandoutViewRow {
    HandoutView view;
    const char* key;  ///< on the command line and in the settings
    const char* name; ///< to be translated in the context HandoutView
};
[[nodiscard]] std::span<const HandoutViewRow> handoutViews();
/// Reads "feeds,limits"; empty if one is unknown. An empty text means none of them.
[[nodiscard]] std::optional<std::set<HandoutView>> readHandoutViews(const QString& text);
[[nodiscard]] QString handoutViewText(const std::set<HandoutView>& views);

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
