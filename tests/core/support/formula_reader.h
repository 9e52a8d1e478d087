// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/formula.h"

#include <array>
#include <stdexcept>
#include <string>

/// Reads the text of a formula as a person would: works it out from the numbers of its terms, and
/// its unit from theirs.
namespace sparkout::fixtures {

/// A value with the exponents of mm, N, s and K, and how far roundings of the numbers on the way
/// may have carried it: what cancels in the printed form is not held against it.
struct Quantity {
    double value = 0;
    std::array<double, 4> dimension{};
    double uncertainty = 0;
};

struct FormulaError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The exponents of a unit such as "N/mm^1.5" or "W/(m·K)"; revolutions and degrees count as
/// numbers. Throws on a unit it does not know.
std::array<double, 4> dimensionOf(const std::string& unit);

/// Works out the right side of a step. Throws when the text cannot be read, a symbol has no term, a
/// term is not used, or units do not go together.
Quantity workOut(const sparkout::FormulaStep& step);

} // namespace sparkout::fixtures
