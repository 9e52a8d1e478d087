// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"
#include "core/simulation/result.h"

#include <QString>

#include <vector>

namespace sparkout::report {

/// Where a formula is from: keys of core/SOURCES.md with the equations there.
struct FormulaSource {
    const char* key;
    const char* equations; ///< "25"; empty: no number
};
[[nodiscard]] std::vector<FormulaSource> sourcesOf(const FormulaSheet& sheet, const Place& at);

/// What a symbol that is no input stands for in a formula; empty: it is not known.
[[nodiscard]] QString symbolMeaning(const FormulaSheet& sheet, const char* symbol);

} // namespace sparkout::report
