// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>

#include <optional>

/// The texts and numbers of outputs, in the current language.
namespace sparkout {

/// Without the unit, as short as its place in a table requires.
[[nodiscard]] QString outputLabel(const OutputRow& row);
/// With the unit, standing alone; `revolutions`: counts revolutions instead of double strokes.
[[nodiscard]] QString outputName(const OutputRow& row, bool revolutions = false);
/// The shortest form for a table.
[[nodiscard]] QString outputBrief(const OutputRow& row, bool revolutions = false);
[[nodiscard]] QString outputHint(const OutputRow& row);

/// A number in its displayed unit; a share or an estimate unchanged.
[[nodiscard]] std::optional<double> outputNumber(const OutputRow& row, const OutputValue& value);
/// The number as a text by threeDigits(); empty if there is none. For amounts, which are never
/// negative.
[[nodiscard]] QString outputText(const OutputRow& row, const OutputValue& value);

/// Three significant digits, at most three decimals, but at least one digit. 0 for a value that is
/// not positive.
[[nodiscard]] QString threeDigits(double value);

} // namespace sparkout
