// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"

#include <cstdint>

namespace sparkout {

/// The value below which the share u of a batch lies, 0 < u < 1: of a uniform factor; of a
/// normal one, truncated to `within` and to what its input allows, x = m + s·Φ⁻¹(Φ(α) + u·(Φ(β) −
/// Φ(α))), α and β the bounds in s from m; of a triangular one of mode c between a and b,
/// a + √(u·(b − a)·(c − a)) up to c, b − √((1 − u)·(b − a)·(b − c)) beyond; of measured values the
/// ⌈u·n⌉-th.
[[nodiscard]] double factorQuantile(const GivenFactor& factor, double share);

/// Of a law over the batch, the value of a part: linear in its place between two dressings; the
/// wheel's diameter changes with each dressing instead, from the first to the last of the batch.
[[nodiscard]] double lawValue(const GivenFactor& factor, std::int64_t part, std::int64_t parts);

/// The rank of a value within its factor's law, from 0 to 1: the share of a batch below it and half
/// of the share that is equal to it; of a law over the batch its place between the ends. ½ of a
/// constant.
[[nodiscard]] double factorRank(const GivenFactor& factor, double value);

/// The median; of a law over the batch the mean of its ends.
[[nodiscard]] double factorMiddle(const GivenFactor& factor);

/// The ends between which corners are taken: the least and greatest value; of a normal factor the
/// bounds it is truncated to, else m ± 3s.
struct FactorEnds {
    double low = 0, high = 0;
};
[[nodiscard]] FactorEnds cornerEnds(const GivenFactor& factor);

/// Puts a value of a factor into a project. The wheel speed falls with the wheel's diameter at
/// the same rev/min; the compliance factor multiplies every γ, or divides every stiffness and E; a
/// measured profile is stretched to the runout; the contact width is the wheel's width in traverse,
/// the ground length in plunge; the machine's form is printed so many times as high, and without
/// one its geometric runout; the gauge's error grows by z repeatabilities and by the drift of t
/// hours.
void putFactor(FactorKind kind, double value, Project& project);
/// The same of a factor that may be one of a zone or section alone: what its input says is
/// replaced.
void putFactor(const GivenFactor& factor, double value, Project& project);

} // namespace sparkout
