// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>

namespace sparkout {

struct Project;
struct Wheel;

/// The wear of the wheel from one surface of a set-up to the next [MODEL-12].
struct WheelWear {
    std::optional<double> dulling_per_mm2; ///< c; not given: the wheel stays as sharp [1/mm²]
    double dulling_exponent = 1;           ///< p; c is in 1/mm²ᵖ
    std::optional<double> grinding_ratio;  ///< G; not given: the wheel keeps its diameter

    [[nodiscard]] bool isGiven() const { return dulling_per_mm2 || grinding_ratio; }
    friend bool operator==(const WheelWear&, const WheelWear&) = default;
};

/// Metal removed by cycles since the wheel was dressed.
struct RemovedMetal {
    double volume_mm3 = 0; ///< V_w
    /// S = Σ V/b, b the width of the wheel in contact: in plunge grinding the ground length,
    /// otherwise the whole width. It determines the wear of the radius.
    double perContact_mm2 = 0;

    RemovedMetal& operator+=(const RemovedMetal& more) {
        volume_mm3 += more.volume_mm3;
        perContact_mm2 += more.perContact_mm2;
        return *this;
    }
    friend RemovedMetal operator+(RemovedMetal a, const RemovedMetal& b) { return a += b; }
    friend RemovedMetal operator*(double parts, const RemovedMetal& of) {
        return {parts * of.volume_mm3, parts * of.perContact_mm2};
    }
    friend bool operator==(const RemovedMetal&, const RemovedMetal&) = default;
};

/// The metal that the cycle of a project has removed, for a total volume.
[[nodiscard]] RemovedMetal removedMetal(const Project& project, double volume_mm3);

/// The wheel after removing this metal since it was dressed: its dullness η = η_0 + c·(V_w/B)ᵖ, at
/// most 1, its diameter by V_w/G = π·B·(D_0² − D²)/4, and the wear of its radius w = w_0 + (D_0 −
/// √(D_0² − 4·S/(π·G)))/2, which the next dressing compensates.
[[nodiscard]] Wheel wheelAfter(const Wheel& dressed, const WheelWear& wear,
                               const RemovedMetal& removed);

/// Replaces the dressed wheel of a project by the worn one, with V_k by its drive.
void wearWheel(Project& project, const WheelWear& wear, const RemovedMetal& removed);

/// Whether a wheel that has removed this metal can wear no further: it is fully dull, and keeps its
/// diameter.
[[nodiscard]] bool isWornOut(const Wheel& dressed, const WheelWear& wear,
                             const RemovedMetal& removed);

template <>
const StructInfo& tableOf<WheelWear>();

} // namespace sparkout
