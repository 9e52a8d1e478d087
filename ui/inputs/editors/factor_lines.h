// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"
#include "core/study/batch_edits.h"
#include "ui/inputs/editors/number_lines.h"

namespace sparkout {

/// The numbers of a factor in one of its forms, with the range of its input.
[[nodiscard]] std::vector<NumberLines::Line> factorLines(const std::string& path,
                                                         const Field& field,
                                                         const GivenFactor& factor,
                                                         FactorForm form);

} // namespace sparkout
