// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/setup/surface_wear.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sparkout {

/// The wheel of a set-up from one dressing to the next [MODEL-12]. Part n comes to a wheel that has
/// removed (n − 1) parts by their drawings, and its surfaces what those before them remove of the
/// part in the cycles as they are.
class WornParts {
public:
    /// Of a set-up whose first part after dressing ran so.
    WornParts(const Setup& setup, const SetupRun& first);

    [[nodiscard]] double partVolume_mm3() const { return m_surfaces.front().part_mm3; }
    /// How the wheel comes to a surface of a part, from 1.
    [[nodiscard]] Wheel wheel(std::size_t surface, std::int64_t part) const {
        return m_surfaces[surface].wheel(part);
    }
    /// Whether it comes to every further part as to this one: it is as dull as can be, and keeps
    /// its diameter.
    [[nodiscard]] bool isWornOut(std::int64_t part) const {
        return m_surfaces.front().isWornOut(part);
    }

private:
    std::vector<SurfaceWear> m_surfaces;
};

} // namespace sparkout
