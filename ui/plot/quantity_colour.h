// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

#include <cstddef>
#include <optional>

namespace sparkout {
enum class Quantity;
}

/// One colour for each thing that is drawn, the same in every view, report and theme.
namespace sparkout::style {

enum class Drawn {
    // Over the time of the cycle.
    programmedFeed, ///< and what is accumulated of it
    actualFeed,     ///< and what is accumulated of it
    radiusBefore,
    radiusAfter,
    axialFeed,
    force,
    oddStage,  ///< bands behind the curves
    evenStage, ///< likewise
    measuredValue,
    simulatedValue,     ///< beside a measured one
    measuredDifference, ///< measured less simulated
    // The part.
    profile, ///< and its spread over the radii
    blank,
    target,
    referenceCircle, ///< least squares, minimum zone
    toleranceField,
    endZone, ///< bands behind the curves; sections, too
    middleZone,
    // Wheel and gauge.
    wheel,
    gauge,
    bestGaugePlace,
    presentGaugePlace,
    allDiameters, ///< of a part, as a band
    // What the system yields by.
    wheelHead,
    headstock,
    tailstock,
    bending,
    rests,
    independentSections,
    coupledSections,
    couplingDifference,
    // Limits and what stands to them.
    limit, ///< of a value
    forbidden,
    everyRequirementHolds,
    holds, ///< a light; so the next two
    close,
    fails,
    // Runs and parts.
    refused,
    sizeNotReached,
    frequency, ///< bars of a count, a contribution
    cumulativeShare,
    mean,
    goodPart,
    partOutside,
    worstPart,
    quickestCycle,
    lowerBound, ///< none is below
    yourCycle,
    steplessLimit,
    count_
};

[[nodiscard]] Drawn drawnAs(Quantity quantity);
[[nodiscard]] QColor colour(Drawn what, const QPalette& palette);

/// Of several alike, such as sections, stages or results, the one at an index; they repeat.
[[nodiscard]] Tone oneOfSeries(std::size_t index);
/// Of the limits of a depth of cut, in their order; those beyond look like the last.
[[nodiscard]] Tone limitOfDepth(std::size_t index);
/// Of the steps of a stroke in their order. Those of one zone stay apart for colour-blind readers,
/// pale as they are drawn.
[[nodiscard]] Tone stepOfStroke(std::size_t index, const QPalette& palette);

} // namespace sparkout::style
