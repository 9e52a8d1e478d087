// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/setup/ground_surface.h"
#include "core/setup/setup_times.h"
#include "core/setup/wheel_wear.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

namespace limits {
inline constexpr std::size_t surfaces = 20;
} // namespace limits

/// A part ground in one set-up: its surfaces in the order in which they are ground. They share the
/// part's body and supports, the material, the wheel and the machine.
struct Setup {
    std::vector<GroundSurface> surfaces; ///< at least one
    SetupTimes times;
    WheelWear wear;

    /// One surface without a name, times and wear: what a file of version 1 holds.
    [[nodiscard]] bool isPlain() const;
    /// By its name, else by its number from 1.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view nameOrNumber) const;
};

/// Where the project of a surface stands in a file of several: "/surfaces/2".
[[nodiscard]] std::string surfacePath(std::size_t surface);

/// What a file of one surface alone holds.
[[nodiscard]] Setup plainSetup(Project project);

/// Faults of the set-up beside those of its projects: ranges of times and wear, names.
[[nodiscard]] Issues checkSetup(const Setup& setup);

} // namespace sparkout
