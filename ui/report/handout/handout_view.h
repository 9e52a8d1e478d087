// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <set>
#include <span>

namespace sparkout::report {

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

} // namespace sparkout::report
