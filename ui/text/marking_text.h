// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/project/wheel_marking.h"

#include <QString>

namespace sparkout {

/// The parts of a wheel's marking in words: "25А white fused alumina; grit F60, …".
[[nodiscard]] QString markingExplained(const WheelMarking& marking);

/// The changes that filling in a wheel from its marking would make: "Grain size 0.25 → 0.26 mm";
/// empty if there are none.
[[nodiscard]] QString markingChanges(const WheelMarking& marking, const Wheel& wheel);

} // namespace sparkout
