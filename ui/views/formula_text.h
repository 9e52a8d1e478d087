// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/formula.h"

#include <QString>

namespace sparkout {

/// A formula with its numbers in the present language, plain text: its name and source, then one
/// paragraph a step, "L = √(a·D_e) = √(0.005·28.6) = 0.378 mm".
[[nodiscard]] QString formulaText(const FormulaSheet& sheet);

/// The same as rich text, with indices below and powers above the line.
[[nodiscard]] QString formulaMarkup(const FormulaSheet& sheet);

} // namespace sparkout
