// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
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

} // namespace sparkout
