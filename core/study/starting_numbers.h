// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace sparkout {

/// A number of the rule of starting cycles, with its meaning and source.
struct StartingNumber {
    double value;
    const char* unit;
    const char* meaning;
    const char* source; ///< key of core/SOURCES.md; empty: an estimate

    constexpr operator double() const { return value; }
};

/// One number for each class of roughness: Ra below 0.8 µm, from 0.8, from 1.6 µm.
using StartingNumbers = std::array<StartingNumber, 3>;

/// All numbers of the rule [MODEL-15]. Estimates without a source are from shop practice, tried on
/// 800 random drawings: the cycles met their drawings in a usual time.
namespace starting {

// Classes of material and surface.
inline constexpr StartingNumber hardFrom{
    45, "HRC", "hardened for feeds; so is a steel without a hardness", ""};
inline constexpr StartingNumber softSpeedBelow{30, "HRC", "unhardened for the work speed", ""};
inline constexpr StartingNumber toolSpeedFrom{62, "HRC", "tool steel for the work speed", ""};
inline constexpr StartingNumber middleRoughness{0.8, "µm", "Ra from which the middle class holds",
                                                ""};
inline constexpr StartingNumber coarseRoughness{1.6, "µm", "Ra from which the coarse class holds",
                                                ""};
inline constexpr StartingNumber roughnessOfField{
    0.05, "T", "Ra where none is required, no less than that of the middle class", ""};

// Work speed V = π·d·n.
inline constexpr StartingNumber softSpeed{30, "m/min", "V of unhardened steel and iron", "MH31"};
inline constexpr StartingNumber hardSpeed{25, "m/min", "V of hardened steel; MH31 has 21", ""};
inline constexpr StartingNumber toolSpeed{22, "m/min", "V of tool steel; MH31 has 15…18", ""};
inline constexpr StartingNumber boreSpeed{1.4, "", "V of a bore over that of a shaft", ""};
inline constexpr StartingNumber greatestBoreSpeed{35, "m/min", "V of a bore at most", ""};
inline constexpr StartingNumber greatestSpeed{40, "m/min",
                                              "V at most, where it is raised against burning", ""};
inline constexpr StartingNumber speedReach{0.05, "", "share by which n may leave that of V", ""};
/// Fractional parts of n_k/n as far as possible from ratios of small whole numbers, at which the
/// wheel's waves stay in place [BADGER2010].
inline constexpr std::array<StartingNumber, 2> restfulParts{
    {{0.382, "", "fractional part of n_k/n that is sought", ""},
     {0.618, "", "fractional part of n_k/n that is sought", ""}}};
inline constexpr StartingNumber restfulReach{0.06, "", "distance from such a part that is as good",
                                             ""};

// Ends of a traverse.
inline constexpr StartingNumber overrun{1. / 3, "B", "overrun at a free end", ""};
inline constexpr StartingNumber shortOverrun{0.5, "B", "overrun at a free end of a short part", ""};
inline constexpr StartingNumber shortPart{1.6, "B", "length below which a part is short", ""};
inline constexpr StartingNumber longestOverrun{
    2. / 3, "B", "overrun at a free end of a part that would have no zone between the reversals",
    ""};
inline constexpr StartingNumber shoulderDwell{1, "rev", "dwell at a shoulder", ""};
inline constexpr StartingNumber reversalFeed{0.5, "mm/min", "S_rad, infeed at a reversal", ""};

// Roughing.
inline constexpr StartingNumber hardRemoval{
    1.5, "mm³/(mm·s)", "Q'_w of a plunge, hardened; MH31 has from 1.0", "MH31"};
inline constexpr StartingNumber softRemoval{
    2.5, "mm³/(mm·s)", "Q'_w of a plunge, unhardened; MH31 has to 4.4", "MH31"};
inline constexpr StartingNumber greatestHardFeed{1.0, "mm/min", "S_p of a plunge at most, hardened",
                                                 ""};
inline constexpr StartingNumber greatestSoftFeed{1.4, "mm/min",
                                                 "S_p of a plunge at most, unhardened", ""};
inline constexpr StartingNumber hardInfeed{0.015, "mm", "S_t of a traverse, hardened", ""};
inline constexpr StartingNumber softInfeed{0.020, "mm", "S_t of a traverse, unhardened", ""};
inline constexpr StartingNumber boreShare{0.5, "", "Q'_w and S_t of a bore over those of a shaft",
                                          ""};
inline constexpr StartingNumber powerShare{0.8, "", "share of the wheel drive's power, wheel worn",
                                           ""};
inline constexpr StartingNumber lagShare{0.12, "Π", "deflection at most, or the least below", ""};
inline constexpr StartingNumber leastLag{0.015, "mm", "deflection that is always allowed", ""};
inline constexpr StartingNumber damagedDepth{0.012, "mm", "damaged layer at most, wheel worn", ""};
inline constexpr StartingNumber wornDullness{1.5, "", "dullness of a worn wheel over the given one",
                                             ""};
inline constexpr StartingNumber wornStress{
    1.1, "", "flow stress of the strongest part over the given one", ""};
/// S_ax of roughing: reduced if power or deflection binds and removal then increases.
inline constexpr std::array<StartingNumber, 5> axialShares{
    {{0.5, "B·n", "unhardened; MH31", "MH31"},
     {0.4, "B·n", "hardened; MH31 has 0.25", ""},
     {0.3, "B·n", "where power or deflection binds", ""},
     {0.25, "B·n", "likewise", ""},
     {0.2, "B·n", "likewise", ""}}};
inline constexpr StartingNumber hardAxialShare{0.4, "B·n", "S_ax at most, hardened or a bore", ""};
inline constexpr StartingNumber worthAShare{1.1, "",
                                            "removal by a lesser S_ax over the one before it", ""};
/// V is increased in these steps if burning limits the depth to less than a share of the table's.
inline constexpr std::array<StartingNumber, 3> speedRises{{{1.25, "V", "against burning", ""},
                                                           {1.5, "V", "against burning", ""},
                                                           {1.75, "V", "against burning", ""}}};
inline constexpr StartingNumber burntShare{
    0.5, "", "share of the table's depth below which V is raised", ""};
inline constexpr StartingNumber worthASpeed{1.02, "",
                                            "removal by a higher V over the one before it", ""};

// Finishing.
inline constexpr StartingNumber plungeFinish{0.05, "T", "depth of cut of a plunge", ""};
inline constexpr StartingNumber leastPlungeFinish{0.05, "mm/min", "S_p at least", ""};
inline constexpr StartingNumbers plungeFinishMost{
    {{0.08, "mm/min", "S_p at most, Ra below 0.8", ""},
     {0.12, "mm/min", "Ra from 0.8; MH31 0.1…0.2", "MH31"},
     {0.15, "mm/min", "Ra from 1.6; MH31 0.1…0.2", "MH31"}}};
inline constexpr StartingNumber finishOfRough{1. / 3, "", "share of the rough S_p at most", ""};
inline constexpr StartingNumber finishOfRoughBore{0.5, "", "likewise, of a bore", ""};
inline constexpr StartingNumber finishLag{
    0.2, "T", "deflection of finishing, above which S_p is lessened", ""};
inline constexpr StartingNumber lessFinish{0.01, "mm/min", "by which it is lessened", ""};
inline constexpr StartingNumber leastFinish{0.03, "mm/min", "S_p that is not lessened", ""};
inline constexpr StartingNumber strokeFinish{0.12, "T", "S_t of finishing at most", ""};
inline constexpr StartingNumber greatestStrokeFinish{
    0.006, "mm", "S_t of finishing at most; MH31 0.003…0.013", "MH31"};
inline constexpr StartingNumber strokeFinishOfRough{0.7, "", "share of the rough S_t at most", ""};
inline constexpr StartingNumbers axialFinish{{{0.2, "B·n", "S_ax, Ra below 0.8; MH31 1/8…1/6", ""},
                                              {0.25, "B·n", "S_ax, Ra from 0.8", ""},
                                              {0.35, "B·n", "S_ax, Ra from 1.6", ""}}};
inline constexpr StartingNumber finishOfBurn{
    0.7, "", "share of the depth that burns the surface, wheel worn", ""};

// A part that yields unevenly, where it is searched about the cycle.
inline constexpr StartingNumber unevenLag{
    0.1, "T", "difference of the lags along the part behind the spark-out at most, wheel worn", ""};
/// S_ax of finishing, reduced while more is left with most spark-outs.
inline constexpr std::array<StartingNumber, 4> evenShares{
    {{0.15, "B·n", "where the part yields unevenly", ""},
     {0.1, "B·n", "likewise", ""},
     {0.07, "B·n", "likewise", ""},
     {0.05, "B·n", "likewise", ""}}};
inline constexpr StartingNumber evenStrokes{
    10, "double strokes", "spark-out at most, where the part yields unevenly", ""};

// Spark-out.
inline constexpr StartingNumbers sparkOutTime{{{6, "s", "of a plunge, Ra below 0.8", ""},
                                               {4, "s", "Ra from 0.8", ""},
                                               {3, "s", "Ra from 1.6", ""}}};
inline constexpr StartingNumbers sparkOutStrokes{
    {{3, "double strokes", "of a traverse, Ra below 0.8", ""},
     {2, "double strokes", "Ra from 0.8", ""},
     {2, "double strokes", "Ra from 1.6", ""}}};
inline constexpr StartingNumber leastRevolutions{3, "rev", "spark-out of a plunge at least", ""};
inline constexpr StartingNumber leastStrokes{1, "double strokes",
                                             "spark-out of a traverse at least", ""};
inline constexpr StartingNumber sparkOutRemoval{0.25, "T", "what a spark-out may remove", ""};

// Stocks.
inline constexpr StartingNumber leastFinishStock{0.020, "mm", "Π of finishing at least", ""};
inline constexpr StartingNumber plungeLagStock{
    1.2, "", "deflections of roughing in it, wheel worn, plunge", ""};
inline constexpr StartingNumber plungeStepsStock{8, "", "steps of finishing beside them, plunge",
                                                 ""};
inline constexpr StartingNumber strokeLagStock{
    1, "", "deflections of roughing in it, wheel worn, traverse", ""};
inline constexpr StartingNumber strokeStepsStock{5, "", "steps of finishing beside them, traverse",
                                                 ""};
inline constexpr StartingNumber strokeRoughStock{1, "", "steps of roughing beside them, traverse",
                                                 ""};
inline constexpr StartingNumber finishStockStep{0.005, "mm", "Π of finishing is rounded up to", ""};
inline constexpr StartingNumber greatestFinishStock{0.5, "Π", "Π of finishing at most", ""};
inline constexpr StartingNumber stockStep{0.0005, "mm", "Π of the spark-out is rounded to", ""};

// Steps of settings where the machine gives none.
inline constexpr StartingNumber infeedStep{0.0005, "mm", "of S_t", ""};
inline constexpr StartingNumber axialStep{10, "mm/min", "of S_ax", ""};
inline constexpr StartingNumber plungeStep{0.01, "mm/min", "of S_p and S_rad", ""};
inline constexpr StartingNumber speedStep{1, "rev/min", "of n", ""};

// Requirements of shop practice in traverse grinding.
inline constexpr StartingNumber leastOverlap{1.05, "", "B·n/S_ax of every stage", ""};
inline constexpr StartingNumber leastOverlapLast{2, "", "B·n/S_ax of the last stage", ""};

// Values that neither drawing nor catalogue give.
inline constexpr StartingNumber machineRunout{
    1.5, "µm", "of centres and spindle, where the machine has none", ""};
inline constexpr StartingNumber quillBeyond{15, "mm", "quill beyond the length of the bore", ""};
inline constexpr StartingNumber quillShare{0.7, "D", "diameter of the quill", ""};

// The wheel of the catalogue.
inline constexpr StartingNumber widestBoreWheel{
    0.9, "d", "diameter of a wheel that is chosen for a bore, at most", ""};
inline constexpr StartingNumber leastShaftWheel{
    100, "mm", "diameter of a wheel that is chosen for a shaft, at least", ""};
/// Grain by the required roughness, as F46…F60 for coarse work and F80…F100 for fine work.
inline constexpr StartingNumber roughGrit{46, "F", "Ra above coarseRoughness", ""};
inline constexpr StartingNumber usualGrit{60, "F", "Ra from middleRoughness", ""};
inline constexpr StartingNumber fineGrit{70, "F", "Ra below it: F60…F80", ""};
inline constexpr StartingNumber finestGrit{90, "F", "Ra up to finestRoughness: F80…F100", ""};
inline constexpr StartingNumber finestRoughness{0.4, "µm",
                                                "Ra up to which the finest grain is used", ""};

} // namespace starting

} // namespace sparkout
