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

/// One surface of a document. Kept runs may be megabytes: steps of the history that do not change
/// them share them.
struct SurfaceState {
    int id = 0; ///< stays with the surface whatever is edited or moved
    std::string name;
    Project project; ///< without its runs
    std::shared_ptr<const std::vector<KeptRun>> runs;
    std::vector<std::string> open{}; ///< paths of the numbers that are yet to be given
    /// Once they are a starting cycle is made for them; else the cycle stays as it is.
    bool startsWhenDrawn = true;

    [[nodiscard]] Project withRuns() const;
};
using SurfaceStatePtr = std::shared_ptr<const SurfaceState>;

/// A value of the history of a document: the set-up and which of its surfaces is in front.
/// Surfaces that a step does not change are shared.
struct SetupState {
    std::vector<SurfaceStatePtr> surfaces; ///< at least one
    std::size_t present = 0;
    SetupTimes times;
    WheelWear wear;

    [[nodiscard]] const SurfaceState& inFront() const { return *surfaces[present]; }
    [[nodiscard]] std::optional<std::size_t> indexOf(int id) const;
    [[nodiscard]] Setup setup() const; ///< with the kept runs
};

/// A surface whose kept runs are shared with another state of it, where they are the same.
[[nodiscard]] SurfaceState surfaceState(int id, std::string name, Project project,
                                        const SurfaceState* before = nullptr);

/// Whether two states hold the same values.
[[nodiscard]] bool sameState(const SetupState& a, const SetupState& b);

} // namespace sparkout
