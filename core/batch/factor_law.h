// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"

#include <cstdint>
#include <optional>

namespace sparkout {

/// The value below which the share u of a batch lies, 0 < u < 1. Uniform law: linear; normal law,
/// truncated to `within` and to the range of its input: x = m + s·Φ⁻¹(Φ(α) + u·(Φ(β) − Φ(α))), α
/// and β the bounds in s from m; triangular law of mode c between a and b: a + √(u·(b − a)·(c − a))
/// up to c, b − √((1 − u)·(b − a)·(b − c)) beyond; measured values: the ⌈u·n⌉-th.
[[nodiscard]] double factorQuantile(const GivenFactor& factor, double share);

/// The value of a part by a law over the batch: linear in its place between two dressings; the
/// wheel's diameter changes at each dressing instead, from the first to the last of the batch.
[[nodiscard]] double lawValue(const GivenFactor& factor, std::int64_t part, std::int64_t parts);

/// The rank of a value within its factor's law, from 0 to 1: the share of a batch below it plus
/// half of the share equal to it; for a law over the batch the position between the ends. ½ for a
/// constant.
[[nodiscard]] double factorRank(const GivenFactor& factor, double value);

/// The median; for a law over the batch the mean of its ends.
[[nodiscard]] double factorMiddle(const GivenFactor& factor);

/// The ends for corners: the least and greatest value; for a normal factor the bounds of its
/// truncation, otherwise m ± 3s.
struct FactorEnds {
    double low = 0, high = 0;
};
[[nodiscard]] FactorEnds cornerEnds(const GivenFactor& factor);

/// The project's own value of the input that a factor replaces. Empty for a factor that multiplies
/// an input or adds to it, for the direction of an eccentricity, which belongs to the clamping of a
/// part, and for the runout of a measured profile.
[[nodiscard]] std::optional<double> replacedValue(FactorKind kind, const Project& project);

/// Puts a value of a factor into a project. The wheel speed falls with the wheel's diameter at the
/// same rev/min; the compliance factor multiplies every γ, or divides every stiffness and E; a
/// measured profile is stretched to the runout; the contact width is the wheel's width in traverse,
/// the ground length in plunge; the machine's form, or without one its geometric runout, is
/// multiplied by it; the gauge's error grows by z repeatabilities and by the drift of t hours.
void putFactor(FactorKind kind, double value, Project& project);
/// Puts a factor, possibly of one zone or section, into a project: the value of its input is
/// replaced.
void putFactor(const GivenFactor& factor, double value, Project& project);

} // namespace sparkout
