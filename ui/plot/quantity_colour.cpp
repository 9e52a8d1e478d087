// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/quantity_colour.h"

#include "core/simulation/feed_curves.h"

#include <algorithm>
#include <array>

namespace sparkout::style {

namespace {

struct Row {
    Drawn what;
    std::optional<Tone> tone; ///< empty: the colour of texts
};

constexpr Row table[] = {
    {Drawn::programmedFeed, Tone::blue},
    {Drawn::actualFeed, Tone::vermilion},
    {Drawn::radiusBefore, Tone::green},
    {Drawn::radiusAfter, Tone::purple},
    {Drawn::axialFeed, Tone::orange},
    {Drawn::force, std::nullopt},
    {Drawn::oddStage, Tone::sky},
    {Drawn::evenStage, Tone::yellow},
    {Drawn::measuredValue, Tone::blue},
    {Drawn::simulatedValue, Tone::vermilion},
    {Drawn::measuredDifference, Tone::purple},
    {Drawn::profile, Tone::vermilion},
    {Drawn::blank, Tone::orange},
    {Drawn::target, Tone::blue},
    {Drawn::referenceCircle, Tone::purple},
    {Drawn::toleranceField, Tone::green},
    {Drawn::endZone, Tone::sky},
    {Drawn::middleZone, Tone::yellow},
    {Drawn::wheel, Tone::orange},
    {Drawn::gauge, Tone::blue},
    {Drawn::bestGaugePlace, Tone::green},
    {Drawn::presentGaugePlace, Tone::vermilion},
    {Drawn::allDiameters, Tone::sky},
    {Drawn::wheelHead, Tone::blue},
    {Drawn::headstock, Tone::green},
    {Drawn::tailstock, Tone::orange},
    {Drawn::bending, Tone::purple},
    {Drawn::rests, Tone::vermilion},
    {Drawn::independentSections, Tone::blue},
    {Drawn::coupledSections, Tone::orange},
    {Drawn::couplingDifference, Tone::purple},
    {Drawn::limit, Tone::vermilion},
    {Drawn::forbidden, Tone::vermilion},
    {Drawn::everyRequirementHolds, Tone::green},
    {Drawn::holds, Tone::green},
    {Drawn::close, Tone::orange},
    {Drawn::fails, Tone::vermilion},
    {Drawn::refused, Tone::vermilion},
    {Drawn::sizeNotReached, Tone::orange},
    {Drawn::frequency, Tone::sky},
    {Drawn::cumulativeShare, Tone::vermilion},
    {Drawn::mean, Tone::blue},
    {Drawn::goodPart, Tone::blue},
    {Drawn::partOutside, Tone::vermilion},
    {Drawn::worstPart, Tone::orange},
    {Drawn::quickestCycle, Tone::vermilion},
    {Drawn::lowerBound, Tone::orange},
    {Drawn::yourCycle, Tone::blue},
    {Drawn::steplessLimit, Tone::green},
};

constexpr bool isWhole() {
    std::size_t next = 0;
    for (const Row& row : table) {
        if (row.what != static_cast<Drawn>(next++)) {
            return false;
        }
    }
    return next == static_cast<std::size_t>(Drawn::count_);
}
static_assert(isWhole(), "a row for each thing that is drawn, in the order of the enumeration");

constexpr std::array series{Tone::blue, Tone::orange,    Tone::green, Tone::purple,
                            Tone::sky,  Tone::vermilion, Tone::yellow};
constexpr std::array depthLimits{Tone::blue, Tone::orange, Tone::green, Tone::sky, Tone::purple};
constexpr std::array steps{Tone::orange, Tone::green,  Tone::sky,  Tone::orange,
                           Tone::purple, Tone::yellow, Tone::blue, Tone::sky};

} // namespace

Drawn drawnAs(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmed:
    case Quantity::programmedSum: return Drawn::programmedFeed;
    case Quantity::actual:
    case Quantity::actualSum: return Drawn::actualFeed;
    case Quantity::came: return Drawn::radiusBefore;
    case Quantity::left: return Drawn::radiusAfter;
    case Quantity::axialFeed: return Drawn::axialFeed;
    case Quantity::force: break;
    }
    return Drawn::force;
}

QColor colour(Drawn what, const QPalette& palette) {
    const std::optional<Tone> own = table[static_cast<std::size_t>(what)].tone;
    return own ? tone(*own, palette) : palette.color(QPalette::Text);
}

Tone oneOfSeries(std::size_t index) {
    return series[index % series.size()];
}

Tone limitOfDepth(std::size_t index) {
    return depthLimits[std::min(index, depthLimits.size() - 1)];
}

Tone stepOfStroke(std::size_t index, const QPalette& palette) {
    const Tone own = steps.at(index);
    return own == Tone::blue && isDark(palette) ? Tone::vermilion : own; // where blue is the sky
}

} // namespace sparkout::style
