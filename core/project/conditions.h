// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <algorithm>

/// When a field of the tables is required or relevant.
namespace sparkout::conditions {

inline bool always(const Project&, const void*) {
    return true;
}
/// Whether the wheel travels along the part.
inline bool travels(const Project& p, const void*) {
    return p.operation->travels;
}
inline bool zones(const Project& p, const void*) {
    return p.operation->travels;
}
inline bool sections(const Project& p, const void*) {
    return !p.operation->travels;
}
/// Whether stages set this feed.
template <auto Feed>
bool setsFeed(const Project& p, const void*) {
    return std::ranges::any_of(p.operation->feeds,
                               [](const StageFeed& feed) { return feed.value == Feed; });
}
/// Whether a reading of the gauge ends a stage.
[[nodiscard]] bool gaugeEndsAStage(const Project& p, const void*);
[[nodiscard]] bool byPosition(const Project& p, const void*);
[[nodiscard]] bool external(const Project& p, const void*);
[[nodiscard]] bool internal(const Project& p, const void*);
/// Whether the runout of the wheel is given, in any form.
[[nodiscard]] bool wheelRunout(const Project& p, const void*);
/// Whether an unbalance of the wheel is given, itself or by its grade.
[[nodiscard]] bool unbalanced(const Project& p, const void*);

} // namespace sparkout::conditions
