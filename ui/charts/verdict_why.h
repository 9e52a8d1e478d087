// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QString>

#include <string>

namespace sparkout::verdict {

/// Explains the value of a requirement in a sentence or two with the numbers: for a diameter the
/// parts of its deviation, for a form error the remainder of the blank's, for a limit on passes its
/// worst place.
[[nodiscard]] QString why(const Outcome& outcome, const ConstraintResult& requirement);

/// JSON pointer of the input limited by a requirement on a setting; empty for the others.
[[nodiscard]] std::string inputPath(const ConstraintResult& requirement);

/// The most important requirement of the verdict: the worst unmet, otherwise the closest; null
/// without any.
[[nodiscard]] const ConstraintResult* worst(const Outcome& outcome);

} // namespace sparkout::verdict
