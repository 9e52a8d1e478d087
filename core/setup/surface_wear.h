// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/wheel.h"
#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"

#include <cstddef>
#include <cstdint>

namespace sparkout {

/// What a part loses of a surface by its drawing [mm³]: the stock to the middle of the field, on
/// the nominal diameter, over the ground length without its gaps.
[[nodiscard]] double nominalVolume_mm3(const Project& project);

/// How the wheel comes to one surface of part after part, from one dressing to the next [MODEL-12].
/// Part n comes to a wheel that has removed (n − 1) parts by their drawings, and its surface what
/// those before it remove of the part.
struct SurfaceWear {
    Wheel dressed;
    WheelWear wear;
    double part_mm3 = 0;   ///< of a part, by its drawing
    double before_mm3 = 0; ///< that the surfaces before it lose

    /// Of a part, from 1.
    [[nodiscard]] Wheel wheel(std::int64_t part) const;
    /// Whether it comes to every further part as to this one: it is as dull as can be, and keeps
    /// its diameter.
    [[nodiscard]] bool isWornOut(std::int64_t part) const;
};

/// Of a surface of a set-up, before which so much was removed of the part.
[[nodiscard]] SurfaceWear surfaceWear(const Setup& setup, std::size_t surface, double before_mm3);

} // namespace sparkout
