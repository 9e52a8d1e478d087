// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"

#include <functional>
#include <optional>
#include <set>
#include <span>

namespace sparkout::report {

/// Figures that the hand-out can have.
enum class HandoutView {
    feeds,    ///< feeds around the step, with E1…E5
    cycle,    ///< feeds over the whole cycle
    profiles, ///< cross-sections at the end
    limits,   ///< actual feed under its limits
};
struct HandoutViewRow {
    HandoutView view;
    const char* key;  ///< on the command line and in the settings
    const char* name; ///< to be translated in the context HandoutView
};
[[nodiscard]] std::span<const HandoutViewRow> handoutViews();
/// "feeds,limits"; nothing when one is not known. An empty text is none of them.
[[nodiscard]] std::optional<std::set<HandoutView>> readHandoutViews(const QString& text);
[[nodiscard]] QString handoutViewText(const std::set<HandoutView>& views);

/// What a teacher chooses.
struct HandoutOptions {
    StepWish step = usualStep(); ///< of those that fit the deepest cut
    std::set<HandoutView> views{HandoutView::feeds, HandoutView::cycle, HandoutView::profiles};
    bool answers = true; ///< the key, on a last page of its own
};

/// The course hand-out: a step of the cycle worked out formula by formula with its numbers,
/// figures, and questions whose answers the engine has computed. Of an outcome that ran.
/// `breathe` is called between figures and runs, so that a window may live.
[[nodiscard]] Report courseHandout(
    const OutcomePtr& outcome, const QString& file, const QDate& date,
    const HandoutOptions& options, const std::function<void()>& breathe = [] {});

} // namespace sparkout::report
