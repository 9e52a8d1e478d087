// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sparkout {

/// The wheel of a set-up between two dressings [MODEL-12]. At part n it has removed n − 1 times the
/// removal of all cycles of the first part, as simulated, plus that of the part's earlier surfaces.
class WornParts {
public:
    /// For a set-up with the run of its first part after dressing.
    WornParts(const Setup& setup, const SetupRun& first);

    [[nodiscard]] double partVolume_mm3() const { return m_part.volume_mm3; }
    /// Wears the dressed wheel of a project to its state at a surface of a part, from 1.
    void wear(Project& dressed, std::size_t surface, std::int64_t part) const {
        wearWheel(dressed, m_wear, m_before[surface] + static_cast<double>(part - 1) * m_part);
    }
    /// Whether the wheel no longer changes from this part on.
    [[nodiscard]] bool isWornOut(const Wheel& dressed, std::int64_t part) const {
        return sparkout::isWornOut(dressed, m_wear, static_cast<double>(part - 1) * m_part);
    }

private:
    WheelWear m_wear;
    RemovedMetal m_part;                ///< metal removed by all surfaces
    std::vector<RemovedMetal> m_before; ///< metal removed by the earlier surfaces of each
};

} // namespace sparkout
