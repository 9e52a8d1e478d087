// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

/// The numbers of the rule of starting cycles [MODEL-15], each with its unit and, in brackets at
/// the end, its source. Numbers without a source are estimates from shop practice, tried on 800
/// random drawings: the cycles met their drawings in a usual time. B is the width of the wheel, n
/// the work speed, T the tolerance and Π the stock.
namespace sparkout::starting {

/// One number for each class of roughness: Ra below 0.8 µm, from 0.8 µm and from 1.6 µm.
using OfRoughness = std::array<double, 3>;

// Classes of material and surface.
inline constexpr double hardFrom = 45; ///< [HRC] hardened; a steel of unknown hardness is so, too
inline constexpr double softSpeedBelow = 30;   ///< [HRC] unhardened, for the work speed
inline constexpr double toolSpeedFrom = 62;    ///< [HRC] tool steel, for the work speed
inline constexpr double middleRoughness = 0.8; ///< [µm] lowest Ra of the middle class
inline constexpr double coarseRoughness = 1.6; ///< [µm] lowest Ra of the coarse class
/// [T] Ra if none is required, at least that of the middle class
inline constexpr double roughnessOfField = 0.05;

// Work speed V = π·d·n.
inline constexpr double softSpeed = 30;         ///< [m/min] V of unhardened steel and iron [MH31]
inline constexpr double hardSpeed = 25;         ///< [m/min] V of hardened steel; 21 in MH31
inline constexpr double toolSpeed = 22;         ///< [m/min] V of tool steel; 15…18 in MH31
inline constexpr double boreSpeed = 1.4;        ///< ratio of V of a bore to that of a shaft
inline constexpr double greatestBoreSpeed = 35; ///< [m/min] maximum V of a bore
inline constexpr double greatestSpeed = 40;     ///< [m/min] maximum V if raised against burning
inline constexpr double speedReach = 0.05;      ///< allowed relative difference of n from that of V
/// Fractional parts of n_k/n as far as possible from ratios of small whole numbers, at which the
/// wheel's waves stay in place [BADGER2010].
inline constexpr std::array restfulParts{0.382, 0.618};
inline constexpr double restfulReach = 0.06; ///< largest distance from such a part

// Ends of a traverse.
inline constexpr double overrun = 1. / 3;   ///< [B] overrun at a free end
inline constexpr double shortOverrun = 0.5; ///< [B] overrun at a free end of a short part
inline constexpr double shortPart = 1.6;    ///< [B] a shorter part is short
/// [B] overrun at a free end of a part that would otherwise have no zone between the reversals
inline constexpr double longestOverrun = 2. / 3;
inline constexpr double shoulderDwell = 1;  ///< [rev] dwell at a shoulder
inline constexpr double reversalFeed = 0.5; ///< [mm/min] S_rad, infeed at a reversal

// Roughing.
/// [mm³/(mm·s)] Q'_w of a plunge, hardened and unhardened; from 1.0 and up to 4.4 in the source
/// [MH31]
inline constexpr double hardRemoval = 1.5, softRemoval = 2.5;
inline constexpr double greatestHardFeed = 1.0; ///< [mm/min] maximum S_p of a plunge, hardened
inline constexpr double greatestSoftFeed = 1.4; ///< [mm/min] maximum S_p of a plunge, unhardened
inline constexpr double hardInfeed = 0.015;     ///< [mm] S_t of a traverse, hardened
inline constexpr double softInfeed = 0.020;     ///< [mm] S_t of a traverse, unhardened
inline constexpr double boreShare = 0.5;  ///< ratio of Q'_w and S_t of a bore to those of a shaft
inline constexpr double powerShare = 0.8; ///< usable share of the wheel drive's power, wheel worn
inline constexpr double lagShare = 0.12;  ///< [Π] maximum deflection, or `leastLag` if greater
inline constexpr double leastLag = 0.015; ///< [mm]
inline constexpr double damagedDepth = 0.012; ///< [mm] maximum damaged layer, wheel worn
inline constexpr double wornDullness = 1.5;   ///< ratio of dullness, worn wheel to given one
inline constexpr double wornStress = 1.1;     ///< ratio of flow stress, strongest part to given one
/// [B·n] S_ax of roughing, unhardened [MH31] and hardened (0.25 in MH31); then, if power or
/// deflection limits the infeed, the next ones, as long as the removal rises.
inline constexpr std::array axialShares{0.5, 0.4, 0.3, 0.25, 0.2};
inline constexpr double hardAxialShare = 0.4; ///< [B·n] maximum S_ax, hardened or a bore
inline constexpr double worthAShare = 1.1;    ///< least ratio of removal, lower S_ax to last one
/// [V] raised in these steps if burning limits the depth to less than `burntShare` of the table's
inline constexpr std::array speedRises{1.25, 1.5, 1.75};
inline constexpr double burntShare = 0.5;
inline constexpr double worthASpeed = 1.02; ///< least ratio of removal, higher V to last one

// Finishing.
inline constexpr double plungeFinish = 0.05;      ///< [T] depth of cut of a plunge
inline constexpr double leastPlungeFinish = 0.05; ///< [mm/min] minimum S_p
/// [mm/min] maximum S_p; 0.1…0.2 for Ra from 0.8 µm [MH31]
inline constexpr OfRoughness plungeFinishMost{0.08, 0.12, 0.15};
inline constexpr double finishOfRough = 1. / 3;  ///< maximum ratio to S_p of roughing
inline constexpr double finishOfRoughBore = 0.5; ///< as above, for a bore
inline constexpr double finishLag = 0.2; ///< [T] deflection of finishing above which S_p is reduced
inline constexpr double lessFinish = 0.01;            ///< [mm/min] step of this reduction
inline constexpr double leastFinish = 0.03;           ///< [mm/min] lowest S_p after it
inline constexpr double strokeFinish = 0.12;          ///< [T] maximum S_t of finishing
inline constexpr double greatestStrokeFinish = 0.006; ///< [mm] as above; 0.003…0.013 in [MH31]
inline constexpr double strokeFinishOfRough = 0.7;    ///< maximum ratio to S_t of roughing
inline constexpr OfRoughness axialFinish{0.2, 0.25,
                                         0.35}; ///< [B·n] S_ax; 1/8…1/6 in MH31 below 0.8
/// Share of the depth that burns the surface, wheel worn.
inline constexpr double finishOfBurn = 0.7;

// A part that yields unevenly, where it is searched about the cycle.
inline constexpr double unevenLag = 0.1; ///< [T] greatest difference of lags, wheel worn
inline constexpr std::array evenShares{0.15, 0.1, 0.07, 0.05}; ///< [B·n] S_ax of finishing
inline constexpr double evenStrokes = 10;                      ///< [double strokes] most spark-outs

// Spark-out.
inline constexpr OfRoughness sparkOutTime{6, 4, 3};    ///< [s] of a plunge
inline constexpr OfRoughness sparkOutStrokes{3, 2, 2}; ///< [double strokes] of a traverse
inline constexpr double leastRevolutions = 3;          ///< [rev] minimum of a plunge
inline constexpr double leastStrokes = 1;              ///< [double strokes] minimum of a traverse
inline constexpr double sparkOutRemoval = 0.25;        ///< [T] maximum removal of a spark-out

// Stock of finishing: deflections of roughing with a worn wheel, plus steps of finishing and
// roughing.
inline constexpr double leastFinishStock = 0.020; ///< [mm] minimum
inline constexpr double plungeLagStock = 1.2, plungeStepsStock = 8;
inline constexpr double strokeLagStock = 1, strokeStepsStock = 5, strokeRoughStock = 1;
inline constexpr double finishStockStep = 0.005;   ///< [mm] the stock is rounded up to this step
inline constexpr double greatestFinishStock = 0.5; ///< [Π] maximum
inline constexpr double stockStep = 0.0005;        ///< [mm] step of the stock of the spark-out

// Steps of settings if the machine has none.
inline constexpr double infeedStep = 0.0005; ///< [mm] of S_t
inline constexpr double axialStep = 10;      ///< [mm/min] of S_ax
inline constexpr double plungeStep = 0.01;   ///< [mm/min] of S_p and S_rad
inline constexpr double speedStep = 1;       ///< [rev/min] of n

// Requirements of shop practice in traverse grinding.
inline constexpr double leastOverlap = 1.05;  ///< B·n/S_ax of every stage
inline constexpr double leastOverlapLast = 2; ///< B·n/S_ax of the last stage

// Values that neither drawing nor catalogue has.
inline constexpr double machineRunout = 1.5; ///< [µm] of centres and spindle
inline constexpr double quillBeyond = 15;    ///< [mm] quill beyond the length of the bore
inline constexpr double quillShare = 0.7;    ///< [D] diameter of the quill

// Choice of a wheel of the catalogue.
inline constexpr double widestBoreWheel = 0.9; ///< [d] maximum diameter for a bore
inline constexpr double leastShaftWheel = 100; ///< [mm] minimum diameter for a shaft
/// [F] grain by the required roughness: F46…F60 for coarse work, F60…F80 for fine work and
/// F80…F100 up to `finestRoughness`
inline constexpr double roughGrit = 46, usualGrit = 60, fineGrit = 70, finestGrit = 90;
inline constexpr double finestRoughness = 0.4; ///< [µm]

} // namespace sparkout::starting
