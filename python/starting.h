// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sparkout::python {

/// starting(), which makes a project with a starting cycle.
void bindStarting(pybind11::module_& module);

} // namespace sparkout::python
