// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"
#include "core/simulation/result.h"

#include <QString>

#include <vector>

namespace sparkout::report {

/// The source of a formula: keys of core/SOURCES.md with the equations there.
struct FormulaSource {
    const char* key;
    const char* equations; ///< "25"; may be empty
};
[[nodiscard]] std::vector<FormulaSource> sourcesOf(const FormulaSheet& sheet, const Place& at);

/// The meaning of a symbol in a formula that is not an input; empty if it is not known.
[[nodiscard]] QString symbolMeaning(const FormulaSheet& sheet, const char* symbol);

} // namespace sparkout::report
