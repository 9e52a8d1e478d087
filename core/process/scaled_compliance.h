// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// Multiplies every elastic deflection under a given force by the factor: scales a given γ, or
/// divides the stiffnesses from which γ is computed (machine, shaft, steady rests), and the wheel
/// contact.
void scaleCompliance(Project& project, double factor);

} // namespace sparkout
