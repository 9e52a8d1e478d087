// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>

#include <optional>

/// The words and numbers of outputs, in the present language.
namespace sparkout {

/// Without its unit, as short as its place in a table allows.
[[nodiscard]] QString outputLabel(const OutputRow& row);
/// With its unit, standing alone; `revolutions`: they are counted, not double strokes.
[[nodiscard]] QString outputName(const OutputRow& row, bool revolutions = false);
/// The same as short as its place in a table allows.
[[nodiscard]] QString outputBrief(const OutputRow& row, bool revolutions = false);
[[nodiscard]] QString outputHint(const OutputRow& row);

/// A number in the unit that it is shown in; of a share or an estimate that itself.
[[nodiscard]] std::optional<double> outputNumber(const OutputRow& row, const OutputValue& value);
/// The same as a text, as threeDigits() has it; empty where there is none. Of amounts, which are
/// never negative.
[[nodiscard]] QString outputText(const OutputRow& row, const OutputValue& value);

/// Three significant digits, three decimals at most, but one digit always. 0 for what is not
/// positive.
[[nodiscard]] QString threeDigits(double value);

} // namespace sparkout
