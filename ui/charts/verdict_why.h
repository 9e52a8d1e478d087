// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QString>

#include <string>

namespace sparkout::verdict {

/// Where the value of a requirement comes from, in a sentence or two with the numbers: for a
/// diameter the shares that add up to its deviation, for a form error what the cycle left of the
/// blank's, for what is watched in every pass the place where it was worst.
[[nodiscard]] QString why(const Outcome& outcome, const ConstraintResult& requirement);

/// JSON pointer of the input that a requirement on a setting is about; empty for the others.
[[nodiscard]] std::string inputPath(const ConstraintResult& requirement);

/// The requirement the verdict speaks of: the worst that fails, else the closest; null without any.
[[nodiscard]] const ConstraintResult* worst(const Outcome& outcome);

} // namespace sparkout::verdict
