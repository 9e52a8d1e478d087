// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/wheel.h"

#include <optional>
#include <string>
#include <string_view>

namespace sparkout {

/// The contents of a grinding wheel's marking: abrasive, grit, hardness, structure, bond, and
/// optionally sizes before and speed after, such as "1 500×50×203 25А F60 L 6 V 35 м/с" or short
/// "25АF60L6V" [GOSTR52781, ISO525].
struct WheelMarking {
    std::string abrasive;         ///< 25А, 14А, 63С …; in the letters of Russian markings
    int grit = 0;                 ///< F grit number
    char hardness = 0;            ///< A, the softest, to Z
    std::optional<int> structure; ///< structure number
    std::string bond;             ///< V vitrified, B resin, R rubber …; with its reinforcement
    std::optional<double> diameter_mm, width_mm, bore_mm;
    std::optional<double> speed_m_s; ///< highest
};

/// Reads a marking; letters may be Cyrillic or Latin, spaces may be missing. Empty if abrasive,
/// grit, hardness or bond is missing, or if part of the text is not understood.
[[nodiscard]] std::optional<WheelMarking> readWheelMarking(std::string_view text);

/// The marking in its usual spelling, "25А F60 L 6 V", with sizes before and speed after if given.
[[nodiscard]] std::string markingText(const WheelMarking& marking);

/// Mean grain of an F grit from F16 to F220 [mm], empty for others. Rounded standard sizes, an
/// estimate for a single wheel.
[[nodiscard]] std::optional<double> grainOfGrit(int grit);

/// W_g = (62 − 2·N)/100 of structure number N, as N_s = 0.5·(62 − 100·W_g) [MODEL-8].
[[nodiscard]] double grainShareOfStructure(int structure);

/// Fills a wheel from its marking: the marking itself, grain, grain share and sizes as far as
/// given; the rest is unchanged.
void applyMarking(const WheelMarking& marking, Wheel& wheel);

} // namespace sparkout
