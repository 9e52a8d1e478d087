// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <stop_token>

namespace sparkout {

class RemovedVolumes;

/// The project of a surface with the wheel as the earlier surfaces leave it, V_k as the drive then
/// gives, and the errors with that wheel, by their paths in the project. If an earlier surface has
/// such errors, these are returned.
struct WornProject {
    std::size_t surface;
    Project project;
    Issues issues;
};

/// The project after a known removal by the earlier surfaces.
[[nodiscard]] WornProject wornProject(const Setup& setup, std::size_t surface,
                                      const RemovedMetal& removed);

/// The project of a surface; runs the earlier surfaces if the wheel wears and their removal is not
/// known.
[[nodiscard]] WornProject wornProject(const Setup& setup, std::size_t surface,
                                      const std::stop_token& stop = {},
                                      RemovedVolumes* known = nullptr);

} // namespace sparkout
