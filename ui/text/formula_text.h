// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/formula.h"

#include <QString>

namespace sparkout {

/// The number of digits with which a reader can check the next line.
inline constexpr int sheetDigits = 5;

/// The number of a term in a formula: "0.0125", "8.38·10⁻⁷", lengths in mm above 1 with their
/// nanometres.
[[nodiscard]] QString formulaNumber(const FormulaTerm& term, int digits = sheetDigits);
/// The value read off those digits.
[[nodiscard]] double shownValue(const FormulaTerm& term, int digits = sheetDigits);

[[nodiscard]] QString formulaHead(const FormulaSheet& sheet);

/// A formula with its numbers in the current language, plain text: its name and source, then one
/// paragraph for each step, "L = √(a·D_e) = √(0.005·28.6) = 0.378 mm".
[[nodiscard]] QString formulaText(const FormulaSheet& sheet);

/// The sources' names of the sheet's force coefficients; empty if it has none.
[[nodiscard]] QString sourceCoefficients(const FormulaSheet& sheet, bool withAxialFeed);

} // namespace sparkout
