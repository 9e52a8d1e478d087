// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

struct Part;

/// The kind of a line of an operation card; the document has the texts.
enum class CardEntry {
    install,   ///< transition: the part is clamped
    fixture,   ///< tooling of that
    grind,     ///< transition: a surface is ground to size
    tooling,   ///< wheel and gauge of that
    settings,  ///< settings besides the regimes: dwells, overruns, commands of the gauge
    regime,    ///< a stage of the cycle
    dress,     ///< transition: the wheel is dressed
    control,   ///< transition: a surface is measured
    measuring, ///< tooling of that
    remove     ///< transition: the part is unloaded
};

/// The service symbol at the beginning of a line.
enum class CardSymbol { none, transition, tooling, regime };
[[nodiscard]] CardSymbol symbolOf(CardEntry entry);

/// A stage with its numbers as set and as simulated.
struct CardRegime {
    int stage = 1; ///< counted from 1
    double diameter_mm = 0;
    double length_mm = 0;
    double stock_mm = 0;        ///< per side
    int steps = 0;              ///< double strokes or revolutions in the run
    bool countsStrokes = false; ///< false: revolutions
    bool feeds = true;          ///< false: it sparks out
    bool untilSize = false;
    double radialFeed = 0; ///< mm per double stroke, or mm/min where revolutions are counted
    std::optional<double> axialFeed_mm_min;
    double continuousFeed_mm_min = 0;
    double workSpeed_rpm = 0;
    double workSpeed_m_min = 0;
    double main_min = 0; ///< main time in the run
};

struct CardLine {
    CardEntry entry = CardEntry::install;
    int transition = 0;                 ///< number from 1; for other lines that of their transition
    std::optional<std::size_t> surface; ///< index into the set-up
    std::optional<CardRegime> regime;   ///< for a regime
    std::optional<double> main_min;     ///< T_o of a transition
    std::optional<double> auxiliary_min; ///< T_a of a transition
    std::vector<double> commands_mm;     ///< settings: stock per side at the end of each stage
    std::vector<std::size_t> measured;   ///< control: the surfaces, beginning with `surface`
};

/// A measuring device: surfaces measured with the same kind form one transition.
struct MeasuringKind {
    bool isBore = false;
    bool hasRunout = false;    ///< radial or total
    bool hasForm = false;      ///< roundness or cylindricity
    bool hasRoughness = false; ///< Ra
    friend bool operator==(const MeasuringKind&, const MeasuringKind&) = default;
};
[[nodiscard]] MeasuringKind measuringKind(const Part& part);

/// An operation card as values: its lines, and the times of the operation.
struct OperationCard {
    std::vector<CardLine> lines;
    std::optional<PieceTime> time; ///< given when every surface is ground to size
};

/// The card of a set-up and its run. A surface that was not run has no regimes. T_a is listed with
/// the transitions unless it is given as a total; the sum of T_o is that of the cycles.
[[nodiscard]] OperationCard operationCard(const Setup& setup, const SetupRun& run);

} // namespace sparkout
