// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

struct Part;

/// What a line of an operation card states; the words are those of the document.
enum class CardEntry {
    install,   ///< transition: the part is clamped
    fixture,   ///< tooling of that
    grind,     ///< transition: a surface is ground to size
    tooling,   ///< wheel and gauge of that
    settings,  ///< what is set beside the regimes: dwells, overruns, commands of the gauge
    regime,    ///< a stage of the cycle
    dress,     ///< transition: the wheel is dressed
    control,   ///< transition: a surface is measured
    measuring, ///< tooling of that
    remove     ///< transition: the part is taken off
};

/// The service symbol at the beginning of a line.
enum class CardSymbol { none, transition, tooling, regime };
[[nodiscard]] CardSymbol symbolOf(CardEntry entry);

/// A stage with its numbers as set and as simulated.
struct CardRegime {
    int stage = 1; ///< from 1
    double diameter_mm = 0;
    double length_mm = 0;
    double stock_mm = 0; ///< per side
    int steps = 0;       ///< double strokes or revolutions of the run
    bool countsStrokes = false;
    bool feeds = true; ///< else it sparks out
    bool untilSize = false;
    double radialFeed = 0; ///< mm per double stroke, or mm/min where `perMinute`
    bool perMinute = false;
    std::optional<double> axialFeed_mm_min;
    double continuousFeed_mm_min = 0;
    double workSpeed_rpm = 0;
    double workSpeed_m_min = 0;
    double main_min = 0; ///< of the run
};

struct CardLine {
    CardEntry entry = CardEntry::install;
    int transition = 0;                  ///< its number from 1; of other lines that they belong to
    std::optional<std::size_t> surface;  ///< index into the set-up
    std::optional<CardRegime> regime;    ///< of a regime
    std::optional<double> main_min;      ///< T_o of a transition
    std::optional<double> auxiliary_min; ///< T_a of a transition
    std::vector<double> commands_mm;     ///< settings: stock per side at which each stage ends
    std::vector<std::size_t> measured;   ///< control: the surfaces, of which `surface` is the first
};

/// What a surface is measured with: surfaces of one kind are one transition.
struct MeasuringKind {
    bool isBore = false;
    bool hasRunout = false;    ///< radial or total
    bool hasForm = false;      ///< roundness or cylindricity
    bool hasRoughness = false; ///< Ra
    friend bool operator==(const MeasuringKind&, const MeasuringKind&) = default;
};
[[nodiscard]] MeasuringKind measuringKind(const Part& part);

/// An operation card as values: its lines in their order, and the times of the operation.
struct OperationCard {
    std::vector<CardLine> lines;
    std::optional<PieceTime> time; ///< when every surface is ground to size
};

/// Of a set-up and its run. A surface that was not run has no regimes. T_a stands with the
/// transitions unless it is given as a whole; the sum of T_o is that of the cycles.
[[nodiscard]] OperationCard operationCard(const Setup& setup, const SetupRun& run);

} // namespace sparkout
