// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <cstddef>
#include <cstdint>
#include <stop_token>

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

} // namespace sparkout
