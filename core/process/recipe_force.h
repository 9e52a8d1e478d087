// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct Wheel; // core/project/wheel.h

/// η of a wheel: its dullness, or what the wear flats of its recipe come to.
[[nodiscard]] double dullnessOf(const Wheel& wheel);

/// Gives a wheel this η, by the input that has a say in it.
void setDullness(Wheel& wheel, double dullness);

/// That input: its path in a project.
[[nodiscard]] const char* dullnessPath(const Wheel& wheel);

} // namespace sparkout
