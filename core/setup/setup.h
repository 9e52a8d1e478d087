// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup_times.h"
#include "core/setup/wheel_wear.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

/// One surface of a set-up: the project of its cycle, including what all surfaces share.
struct GroundSurface {
    std::string name; ///< empty in a file with one surface
    Project project;
};

namespace limits {
inline constexpr std::size_t surfaces = 20;
} // namespace limits

/// A part ground in one set-up: its surfaces in the order in which they are ground. They share the
/// part's body and supports, the material, the wheel and the machine.
struct Setup {
    std::vector<GroundSurface> surfaces; ///< at least one
    SetupTimes times;
    WheelWear wear;

    /// Whether it is one surface without a name, times and wear: the contents of a file of version
    /// 1.
    [[nodiscard]] bool isPlain() const;
    /// Finds a surface by its name, otherwise by its number from 1.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view nameOrNumber) const;
};

/// The path of a surface's project in a file of several: "/surfaces/2".
[[nodiscard]] std::string surfacePath(std::size_t surface);

/// The set-up of a file with one surface.
[[nodiscard]] Setup plainSetup(Project project);

/// Faults of the set-up besides those of its projects: ranges of times and wear, names.
[[nodiscard]] Issues checkSetup(const Setup& setup);

} // namespace sparkout
