// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// Multiplies every elastic deflection under a given force by the factor: γ where it is given, else
/// it divides what γ is computed from (units of the machine, shaft, steady rests); and the wheel
/// contact.
void scaleCompliance(Project& project, double factor);

} // namespace sparkout
