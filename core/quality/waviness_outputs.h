// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/result.h"
#include "core/simulation/result.h"
#include "core/surface/waviness.h"

#include <cstddef>
#include <optional>
#include <span>

/// The waves that a wheel out of true leaves on the part [MODEL-16].
namespace sparkout {

/// The waves of a zone or section, of its most wavy section.
struct PlaceWaves {
    int order = 0; ///< number of waves that the wheel prints
    /// Empty where strips stay uncut, or the project is not valid.
    std::optional<Waviness> waves;

    [[nodiscard]] const Harmonic* largest() const;
};

/// The profile of a zone or section without the orders below half of the wheel's.
[[nodiscard]] Waviness profileWaves(const SimulationResult& result, std::size_t section);

/// Empty where the runout of the wheel is not given: the waves are not known.
[[nodiscard]] std::optional<PlaceWaves> placeWaves(const SimulationResult& result,
                                                   std::size_t section);

[[nodiscard]] std::span<const Output<PlaceWaves>> wavinessOutputs();

} // namespace sparkout
