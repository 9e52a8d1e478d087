// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/project/wheel_marking.h"

#include <QString>

namespace sparkout {

/// A wheel's marking part by part in words: "25А white fused alumina; grit F60, …".
[[nodiscard]] QString markingExplained(const WheelMarking& marking);

/// What filling a project's wheel from its marking would change: "Grain size 0.25 → 0.26 mm";
/// empty when the wheel is as it says.
[[nodiscard]] QString markingChanges(const WheelMarking& marking, const Wheel& wheel);

} // namespace sparkout
