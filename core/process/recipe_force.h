// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct Wheel; // core/project/wheel.h

/// η of a wheel: its dullness, or the value that follows from the wear flats of its recipe.
[[nodiscard]] double dullnessOf(const Wheel& wheel);

/// Gives a wheel this η through the input that determines it.
void setDullness(Wheel& wheel, double dullness);

/// The path of that input in a project.
[[nodiscard]] const char* dullnessPath(const Wheel& wheel);

} // namespace sparkout
