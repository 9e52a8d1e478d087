// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace sparkout {

/// The volumes removed by cycles that were run, so that they need not be run again for the wheel of
/// the next surface. Thread-safe.
class RemovedVolumes {
public:
    static constexpr std::size_t most = 40; ///< the oldest is dropped first

    [[nodiscard]] std::optional<double> find(const Project& project) const; ///< [mm³]
    void add(const Project& project, double removed_mm3);

private:
    mutable std::mutex m_mutex;
    std::deque<std::pair<Project, double>> m_known; ///< without kept runs, which have no influence
};

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
