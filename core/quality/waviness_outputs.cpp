// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/waviness_outputs.h"

#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/ranges.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sparkout {

namespace {

using units::umPerMm;

/// Lower ones are those of the blank and the machine.
int leastOrder(const Project& project) {
    constexpr double least = 2, most = 1e6; // no profile has as many waves
    return static_cast<int>(std::clamp(std::ceil(wavesPerTurn(project) / 2), least, most));
}

constexpr Output<PlaceWaves> wavinessRows[] = {
    {{.key = "height_um",
      .label = SPARKOUT_NOOP("Output", "Waviness"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "From peak to valley, of the profile without the orders "
                                      "below half of the wheel's; of the most wavy section.")},
     [](const PlaceWaves& of) {
         return of.waves ? std::optional(of.waves->height_mm * umPerMm) : std::nullopt;
     }},
    {{.key = "largest_order",
      .label = SPARKOUT_NOOP("Output", "Largest order"),
      .hint = SPARKOUT_NOOP("Output", "Waves around the part of the harmonic with the largest "
                                      "amplitude.")},
     [](const PlaceWaves& of) {
         const Harmonic* const largest = of.largest();
         return largest ? std::optional(std::int64_t{largest->lobes}) : std::nullopt;
     }},
    {{.key = "largest_amplitude_um",
      .label = SPARKOUT_NOOP("Output", "Amplitude of the largest order"),
      .unit = "µm"},
     [](const PlaceWaves& of) {
         const Harmonic* const largest = of.largest();
         return largest ? std::optional(largest->amplitude_mm * umPerMm) : std::nullopt;
     }},
    {{.key = "printed_order",
      .label = SPARKOUT_NOOP("Output", "Waves that the wheel prints"),
      .hint = SPARKOUT_NOOP("Output", "Number around the part, by the ratio of wheel to work "
                                      "speed and the waves of the wheel.")},
     [](const PlaceWaves& of) { return std::int64_t{of.order}; }},
};

} // namespace

const Harmonic* PlaceWaves::largest() const {
    if (!waves || waves->orders.empty()) {
        return nullptr;
    }
    return &*std::ranges::max_element(waves->orders, {}, &Harmonic::amplitude_mm);
}

Waviness profileWaves(const SimulationResult& result, std::size_t section) {
    const std::vector<SectionShape> shapes = shapesOfPlace(result, section);
    const Directions directions(shapes.front().radii_mm.size());
    Waviness most;
    for (const SectionShape& shape : shapes) {
        Waviness each = wavinessOf(shape.radii_mm, directions, leastOrder(result.project));
        if (most.orders.empty() || each.height_mm > most.height_mm) {
            most = std::move(each);
        }
    }
    return most;
}

std::optional<PlaceWaves> placeWaves(const SimulationResult& result, std::size_t section) {
    const Project& project = result.project;
    if (!project.wheel->runout) {
        return std::nullopt;
    }
    PlaceWaves found{orderOfWaves(project), {}};
    if (areWavesKnown(project) && FinishedSurface(project).isWhole()) {
        found.waves = profileWaves(result, section);
    }
    return found;
}

std::span<const Output<PlaceWaves>> wavinessOutputs() {
    return wavinessRows;
}

} // namespace sparkout
