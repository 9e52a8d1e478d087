// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <stop_token>

namespace sparkout {

class RemovedVolumes;

/// The project of a surface with the wheel as the surfaces before have left it, V_k as the drive
/// has it then, and the errors that it has with that wheel, by their paths in the project. Where a
/// surface before has such errors, that one.
struct WornProject {
    std::size_t surface;
    Project project;
    Issues issues;
};

/// After so much was removed before.
[[nodiscard]] WornProject wornProject(const Setup& setup, std::size_t surface,
                                      const RemovedMetal& removed);

/// The same; the surfaces before are run, if the wheel wears and it is not known what they remove.
[[nodiscard]] WornProject wornProject(const Setup& setup, std::size_t surface,
                                      const std::stop_token& stop = {},
                                      RemovedVolumes* known = nullptr);

} // namespace sparkout
