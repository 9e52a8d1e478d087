// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// The factors a batch may scatter by, in the order of their table.
enum class FactorKind {
    stock,
    runout,
    dullness,
    wheelDiameter,
    flowStress,
    compliance,
    contactWidth
};

/// A factor of a batch that is given, with what its input allows.
struct GivenFactor {
    FactorKind kind;
    Factor law;    ///< measured values in rising order
    Range allowed; ///< hard limits of the input it stands for

    /// Follows the number of the part and takes no random number.
    [[nodiscard]] bool isLaw() const { return law.grows.has_value(); }
};

/// The given factors in the order of the table: the order of the correlation matrix.
[[nodiscard]] std::vector<GivenFactor> givenFactors(const Project& project);

/// Key of a factor in the file, "stock_mm".
[[nodiscard]] const char* factorKey(FactorKind kind);

} // namespace sparkout
