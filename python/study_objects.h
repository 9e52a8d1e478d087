// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sparkout::python {

/// evaluate(), batch(), sweep(), search() and what they give.
void bindStudies(pybind11::module_& module);

} // namespace sparkout::python
