// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/read_curves.h"
#include "ui/kit/theme.h"

#include <QColor>
#include <QPen>
#include <QPixmap>
#include <QString>

#include <cstddef>
#include <optional>

namespace sparkout {
enum class Quantity;
}

/// One colour for each kind of drawn object, the same in every view, report and theme.
namespace sparkout::style {

enum class Drawn {
    programmedFeed, ///< also accumulated
    actualFeed,     ///< also accumulated
    radiusBefore,
    radiusAfter,
    axialFeed,
    force,
    oddStage,  ///< bands behind the curves
    evenStage, ///< also a stage
    measuredValue,
    simulatedValue,     ///< next to a measured one
    measuredDifference, ///< measured less simulated
    // The part.
    profile, ///< with its spread over the radii
    blank,
    target,
    referenceCircle, ///< least squares, minimum zone
    toleranceField,
    endZone, ///< bands behind the curves, also sections
    middleZone,
    // Wheel and gauge.
    wheel,
    gauge,
    bestGaugePlace,
    presentGaugePlace,
    allDiameters, ///< diameters of a part, as a band
    // Parts of the compliance.
    wheelHead,
    headstock,
    tailstock,
    bending,
    rests,
    independentSections,
    coupledSections,
    couplingDifference,
    // Limits and values compared with them.
    limit, ///< limit of a value
    forbidden,
    everyRequirementHolds,
    holds, ///< a light, like the next two
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

/// The colour of one of several similar series, such as sections, stages or results, by index; the
/// colours repeat.
[[nodiscard]] Tone oneOfSeries(std::size_t index);
/// The colour of a limit of the depth of cut, by its order; later ones repeat the last.
[[nodiscard]] Tone limitOfDepth(std::size_t index);
/// The colour of a step of a stroke, by its order. Steps of one zone stay distinct for colour-blind
/// readers despite pale fills.
[[nodiscard]] Tone stepOfStroke(std::size_t index, const QPalette& palette);

// A dash pattern and width for each curve in addition to its colour, so that curves differ in
// black and white print, too.

/// A solid line of the usual width for a curve without neighbours.
[[nodiscard]] QPen line(Drawn what, const QColor& colour);
/// The line of a limit of the depth of cut, by its order; later ones repeat the last.
[[nodiscard]] QPen lineOfDepthLimit(std::size_t index, const QColor& colour);

} // namespace sparkout::style

namespace sparkout {

/// The line of one of several runs: the current run, number 0, is solid; the others have different
/// dashes, and wider lines once these repeat.
[[nodiscard]] QVector<qreal> runDash(int number); ///< in pen widths; empty: solid
[[nodiscard]] QPen runPen(int number, const QColor& colour);

/// A sample of the line for a list.
[[nodiscard]] QPixmap runSample(int number, const QColor& colour, const QSize& size, qreal ratio);

enum class StrokeStep;

/// "E3/E1/E1 working stroke": a step of a double stroke with its code in each of the zones ground
/// in it; empty if it has none.
[[nodiscard]] QString strokeStepName(StrokeStep step);

/// The name of a curve in the legend.
[[nodiscard]] QString quantityName(Quantity quantity);

/// The name with the unit: "actual feed, µm".
[[nodiscard]] QString quantityWithUnit(Quantity quantity);

/// The number format of its values.
[[nodiscard]] Digits quantityDigits(Quantity quantity);

/// The values at a time as two lines of plain text: the place in the cycle, and the numbers. Empty
/// if the zone has no point there.
[[nodiscard]] QString feedText(const FeedPoints& points, double time_s, const FeedSeries& series,
                               bool wholeStrokes);

} // namespace sparkout
