// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <pybind11/pybind11.h>

#include <vector>

namespace sparkout::python {

/// Requirements as a list of dictionaries, `Requirement` of the stubs.
[[nodiscard]] pybind11::list requirementList(const std::vector<ConstraintResult>& constraints);

} // namespace sparkout::python
