// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Limit deviations of shafts and holes by ISO 286-1 and -2 (ГОСТ 25346, 25347), nominal sizes up
/// to 500 mm, grades IT4 to IT14, deviations d to p and D to P. The values are the tables' own. The
/// standard derives them: i = 0.45·∛D + 0.001·D (D the geometric mean of the range), IT5…IT14 = 7,
/// 10, 16, 25, 40, 64, 100, 160, 250, 400·i; es = −16·D^0.44 (d), −11·D^0.41 (e), −5.5·D^0.41 (f),
/// −2.5·D^0.34 (g); ei = 0.6·∛D (k), IT7 − IT6 (m), 5·D^0.34 (n), IT7 + 0…5 (p). The tables round
/// irregularly in places (IT6 to 3 mm is 6, not 5; IT7 of 6…10 mm 15, not 14; e of 30…50 mm 50, not
/// 49), so their values are used; a test lists every such value. [ISO286]
namespace sparkout {

/// A size with its tolerance field on a drawing: 30h6.
struct SizeDesignation {
    double nominal_mm = 0;
    std::string letters; ///< h, js, H, JS: small for shafts, capital for holes
    int grade = 0;       ///< IT grade

    [[nodiscard]] bool isHole() const { return !letters.empty() && letters[0] <= 'Z'; }
};

/// Deviations from the nominal size [µm].
struct SizeDeviations {
    double upper_um = 0; ///< es, ES
    double lower_um = 0; ///< ei, EI
};

/// Reads "30h6", "Ø30 H7", "38,74h6". Point or comma; a diameter sign and blanks are optional;
/// Cyrillic letters that look like Latin ones (Н7, к6) are accepted. Empty if the text is not a
/// designation; sizeDeviations() checks that the field exists.
[[nodiscard]] std::optional<SizeDesignation> parseSizeDesignation(std::string_view text);

/// A keyway on a drawing: width with its tolerance field, length, and the place of its first edge.
struct KeywayDesignation {
    double width_mm = 0;
    std::string field; ///< "P9"; may be empty
    std::optional<double> length_mm;
    std::optional<double> at_deg;
};

/// Reads "12P9 × 45", "12P9x45", "12 × 45", "12P9", and a position after it, "12P9 × 45, 90°".
/// Empty if the text is not a designation or a number is not positive.
[[nodiscard]] std::optional<KeywayDesignation> parseKeyway(std::string_view text);

/// The angle between the edges of a keyway on a diameter, 2·asin(w/d) [°]; empty if it is not
/// narrower than the diameter.
[[nodiscard]] std::optional<double> keywayAngle(double width_mm, double diameter_mm);

/// Standard tolerance IT [µm]; empty outside 0 < size ≤ 500 mm or IT4…IT14.
[[nodiscard]] std::optional<double> standardTolerance(double nominal_mm, int grade);

/// Limit deviations of a field; empty where the standard or this table has none.
[[nodiscard]] std::optional<SizeDeviations> sizeDeviations(const SizeDesignation& designation);

} // namespace sparkout
