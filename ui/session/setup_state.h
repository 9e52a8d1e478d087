// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// One surface of a document. Kept runs may take megabytes, so steps of the history that do not
/// change them share them.
struct SurfaceState {
    int id = 0; ///< stays with the surface through all edits and moves
    std::string name;
    Project project; ///< without its runs
    std::shared_ptr<const std::vector<KeptRun>> runs;
    std::vector<std::string> open{}; ///< paths of the numbers that are still to be entered
    /// Whether a starting cycle is made once they are entered; otherwise the cycle stays as it is.
    bool startsWhenDrawn = true;

    [[nodiscard]] Project withRuns() const;
};
using SurfaceStatePtr = std::shared_ptr<const SurfaceState>;

/// A value of the history of a document: the set-up and its current surface. Surfaces that a step
/// does not change are shared.
struct SetupState {
    std::vector<SurfaceStatePtr> surfaces; ///< at least one
    std::size_t present = 0;
    SetupTimes times;
    WheelWear wear;

    [[nodiscard]] const SurfaceState& inFront() const { return *surfaces[present]; }
    [[nodiscard]] std::optional<std::size_t> indexOf(int id) const;
    [[nodiscard]] Setup setup() const; ///< set-up with the kept runs
};

/// Makes a surface that shares its kept runs with `before` where they are the same.
[[nodiscard]] SurfaceState surfaceState(int id, std::string name, Project project,
                                        const SurfaceState* before = nullptr);

/// Returns whether two states have the same values.
[[nodiscard]] bool sameState(const SetupState& a, const SetupState& b);

} // namespace sparkout
