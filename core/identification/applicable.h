// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fitted_parameter.h"
#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// Whether all these parameters apply to the project, and none is given twice: compliances only of
/// places with their own, no runout of a measured blank, no α and β of a wheel contact.
[[nodiscard]] bool areApplicable(const Project& project, const std::vector<FittedParameter>& list);

} // namespace sparkout
