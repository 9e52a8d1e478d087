// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>

namespace sparkout {

struct Wheel;

/// How the wheel goes on from one surface of a set-up to the next [MODEL-12].
struct WheelWear {
    std::optional<double> dulling_per_mm2; ///< c; not given: the wheel stays as sharp [1/mm²]
    double dulling_exponent = 1;           ///< p; c is in 1/mm²ᵖ
    std::optional<double> grinding_ratio;  ///< G; not given: the wheel keeps its diameter

    [[nodiscard]] bool isGiven() const { return dulling_per_mm2 || grinding_ratio; }
    friend bool operator==(const WheelWear&, const WheelWear&) = default;
};

/// The wheel after it has removed a volume [mm³] since it was dressed: its dullness
/// η = η_0 + c·(V_w/B)ᵖ, at most 1, and its diameter by V_w/G = π·B·(D_0² − D²)/4.
[[nodiscard]] Wheel wheelAfter(const Wheel& dressed, const WheelWear& wear, double removed_mm3);

template <>
const StructInfo& tableOf<WheelWear>();

} // namespace sparkout
