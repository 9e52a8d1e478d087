// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace sparkout {

/// The volume to be removed from a surface by the drawing [mm³]: the stock to the middle of the
/// tolerance, on the nominal diameter, over the ground length without its gaps.
[[nodiscard]] double nominalVolume_mm3(const Project& project);

/// The set-up with a newly dressed wheel, without wear of its radius.
[[nodiscard]] Setup dressedSetup(Setup setup);

/// One surface of a set-up, ground in part after part between two dressings.
struct SurfaceWear {
    /// Uses the set-up as read, with a dressed wheel.
    SurfaceWear(Setup of, std::size_t at);
    /// Uses a wheel that does not wear.
    explicit SurfaceWear(const Project& project);

    Setup setup; ///< only with the inputs that its cycles read
    std::size_t surface = 0;

    [[nodiscard]] const WheelWear& wear() const { return setup.wear; }
};

/// Whether the wheel reaches the surface in the same state, whatever its own cycle.
[[nodiscard]] bool sameWear(const SurfaceWear& a, const SurfaceWear& b);

/// The state of the wheel at the surface for part after part [MODEL-12]: before part n it has
/// removed n − 1 times the volume of all cycles of the first part, as simulated, and that of the
/// earlier surfaces of the part. Another surface whose cycle cannot be run, or does not reach size,
/// counts with its stock by the drawing. A value type.
class WheelCourse {
public:
    /// Runs the earlier surfaces. `surface` must outlive the course and its copies.
    explicit WheelCourse(const SurfaceWear& surface, const std::stop_token& stop = {});
    /// The course for a cycle that removes this volume from the surface of the first part; runs the
    /// later surfaces. After a stop the result must not be used.
    [[nodiscard]] WheelCourse ofCycle(double removed_mm3, const std::stop_token& stop = {}) const;

    /// Gives a project of the surface the state of the wheel at a part, from 1; for the first part
    /// also before the cycle is known.
    void putWheel(Project& project, std::int64_t part) const;
    /// Whether the wheel is in the same state for all later parts: fully dull, and with a constant
    /// diameter.
    [[nodiscard]] bool isWornOut(std::int64_t part) const;

private:
    [[nodiscard]] const Project& dressed() const {
        return m_surface->setup.surfaces[m_surface->surface].project;
    }
    [[nodiscard]] RemovedMetal before(std::int64_t part) const {
        return m_before + static_cast<double>(part - 1) * m_part;
    }
    void grindOthers(std::size_t from, std::size_t to, const std::stop_token& stop);

    const SurfaceWear* m_surface;
    RemovedMetal m_before; ///< removed in the first part
    RemovedMetal m_part;   ///< removed from all surfaces, as far as known
};

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
