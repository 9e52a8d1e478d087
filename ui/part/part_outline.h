// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/setup_state.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

/// The part of a set-up as drawn from the side: the steps of its body, and the ground surfaces.
struct PartOutline {
    struct Step {
        double from_mm = 0; ///< distance from the headstock end
        double length_mm = 0;
        double diameter_mm = 0;

        [[nodiscard]] double to_mm() const { return from_mm + length_mm; }
    };
    struct Ground : Step {
        bool isInternal = false;
    };

    std::vector<Step> steps;      ///< from the headstock; those of the drawing
    std::vector<Ground> surfaces; ///< in the order of the set-up
    bool hasSteps = false;        ///< false: the body is assumed around the ground surfaces
    double length_mm = 0;
    double diameter_mm = 0; ///< the largest

    [[nodiscard]] static PartOutline of(const SetupState& state);

    [[nodiscard]] std::optional<std::size_t> stepAt(double x_mm) const;
    /// The surface at a place: of several the shortest.
    [[nodiscard]] std::optional<std::size_t> surfaceAt(double x_mm) const;
    /// Whether no more than a part of a step is ground.
    [[nodiscard]] bool isFree(std::size_t step) const;
    [[nodiscard]] std::optional<std::size_t> firstFreeStep() const;
};

} // namespace sparkout
