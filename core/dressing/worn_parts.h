// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sparkout {

/// The wheel of a set-up from one dressing to the next [MODEL-12]. Part n comes to a wheel that has
/// removed n − 1 times what the cycles of the first part remove, as simulated, and its surfaces
/// what those before them remove of it.
class WornParts {
public:
    /// Of a set-up whose first part after dressing ran so.
    WornParts(const Setup& setup, const SetupRun& first);

    [[nodiscard]] double partVolume_mm3() const { return m_part.volume_mm3; }
    /// Wears the dressed wheel of a project to that which comes to a surface of a part, from 1.
    void wear(Project& dressed, std::size_t surface, std::int64_t part) const {
        wearWheel(dressed, m_wear, m_before[surface] + static_cast<double>(part - 1) * m_part);
    }
    /// Whether the wheel comes to every further part as to this one.
    [[nodiscard]] bool isWornOut(const Wheel& dressed, std::int64_t part) const {
        return sparkout::isWornOut(dressed, m_wear, static_cast<double>(part - 1) * m_part);
    }

private:
    WheelWear m_wear;
    RemovedMetal m_part;                ///< of all surfaces
    std::vector<RemovedMetal> m_before; ///< of the surfaces before each
};

} // namespace sparkout
