// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <cstddef>
#include <cstdint>
#include <stop_token>

namespace sparkout {

/// What a part loses of a surface by its drawing [mm³]: the stock to the middle of the field, on
/// the nominal diameter, over the ground length without its gaps.
[[nodiscard]] double nominalVolume_mm3(const Project& project);

/// The set-up with a wheel that was just dressed, which compensates the wear of its radius.
[[nodiscard]] Setup dressedSetup(Setup setup);

/// One surface of a set-up, which is ground in part after part from one dressing to the next.
struct SurfaceWear {
    /// Of the set-up as it is read; the wheel is taken to be dressed.
    SurfaceWear(Setup of, std::size_t at);
    /// Of a wheel that does not wear.
    explicit SurfaceWear(const Project& project);

    Setup setup; ///< with what the cycles of its surfaces read, and no more
    std::size_t surface = 0;

    [[nodiscard]] const WheelWear& wear() const { return setup.wear; }
};

/// Whether the wheel comes to the surface alike, whatever its own cycle.
[[nodiscard]] bool sameWear(const SurfaceWear& a, const SurfaceWear& b);

/// The wheel as it comes to the surface of part after part [MODEL-12]: part n after n − 1 times
/// what the cycles of the first part remove, as simulated, and what those of the surfaces before
/// remove of the part. A surface beside whose cycle cannot be run, or does not reach size, loses
/// its stock by the drawing. A value.
class WheelCourse {
public:
    /// Runs the surfaces before. `surface` must outlive the course and its copies.
    explicit WheelCourse(const SurfaceWear& surface, const std::stop_token& stop = {});
    /// Of a cycle that removes so much of the surface of the first part; runs the surfaces after
    /// it. A stop leaves the course of no use.
    [[nodiscard]] WheelCourse ofCycle(double removed_mm3, const std::stop_token& stop = {}) const;

    /// Gives a project of the surface the wheel as it comes to it in a part, from 1; to the first
    /// one as well before the cycle is known.
    void putWheel(Project& project, std::int64_t part) const;
    /// Whether it comes to every further part as to this one: it is as dull as can be, and keeps
    /// its diameter.
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
    RemovedMetal m_before; ///< in the first part
    RemovedMetal m_part;   ///< of all surfaces, as far as they are known
};

} // namespace sparkout
