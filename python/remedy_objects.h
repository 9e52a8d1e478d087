// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sparkout::python {

/// remedies() and what it gives.
void bindRemedies(pybind11::module_& module);

} // namespace sparkout::python
