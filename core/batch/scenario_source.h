// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/given_factors.h"
#include "core/project/project.h"
#include "core/statistics/value_bins.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

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

/// Correlates factors by a Gaussian copula: independent shares u become normal scores z = Φ⁻¹(u),
/// L·z with R = L·Lᵀ are scores of correlation R, and back to shares. R is the correlation of the
/// scores: of normal factors Pearson's own, of others the rank correlation is (6/π)·asin(R/2).
///
/// Not by Iman and Conover's reordering [IMAN1982]: that needs the whole sample at once, and a part
/// here must be known from its number alone. As a drawback, only the first factor of a Latin
/// hypercube keeps its strata exactly.
class Correlation {
public:
    /// Empty if the matrix is not positive definite. It must be square with ones on its diagonal.
    static std::optional<Correlation> of(const std::vector<std::vector<double>>& matrix);

    /// Turns independent shares into correlated ones.
    void apply(std::span<double> shares) const;

private:
    std::vector<std::vector<double>> m_lower; ///< L, row i of i + 1 values
};

/// The parts of a batch [MODEL-8], each made from its number alone: part 17 is the same in any
/// order and on any thread or machine. The batch must pass checkBatch().
///
/// Latin hypercube: part i of N draws factor f from stratum π_f(i) of N, π_f a random permutation
/// [MCKAY1979]. Sobol: point i, shifted by a random digital shift; with a law over the batch the
/// points are taken in random order, to decorrelate their bits from it. Corners: bit f of i selects
/// the end; without factors there is one part, the nominal one. Factors of the part come before
/// those of its zones, which are drawn independently of all others.
class ScenarioSource {
public:
    explicit ScenarioSource(Project project);

    [[nodiscard]] std::int64_t parts() const { return m_parts; }
    [[nodiscard]] const std::vector<GivenFactor>& factors() const { return m_factors; }
    [[nodiscard]] std::uint32_t seed() const { return static_cast<std::uint32_t>(m_batch.seed); }
    /// Whether the parts are a sample of a distribution, and not its extremes.
    [[nodiscard]] bool isSample() const { return m_isSample; }

    /// The values of the factors for a part.
    [[nodiscard]] std::vector<double> values(std::int64_t part) const;
    /// The part as a project without a batch, to be run again.
    [[nodiscard]] Project project(std::int64_t part) const;
    [[nodiscard]] Project projectWith(const std::vector<double>& values) const;
    /// The ranks of these values within the laws of their factors.
    [[nodiscard]] RankScores scores(const std::vector<double>& values) const;
    /// The project itself, with every factor at its input.
    [[nodiscard]] const Project& nominal() const { return m_nominal; }

private:
    [[nodiscard]] double share(std::int64_t part, std::size_t factor) const;

    Project m_nominal;
    Batch m_batch;
    std::vector<GivenFactor> m_factors;
    std::vector<GivenFactor> m_constants; ///< factors of zones that do not scatter
    std::size_t m_ofPart = 0;             ///< number of factors of the whole part, which come first
    std::optional<Correlation> m_correlation;
    std::int64_t m_parts = 1;
    bool m_isSample = true;
    bool m_hasLaw = false;
};

/// Parts drawn for the last test of a cycle: if none of them is bad, at most mostFailing() of all
/// are, with 95 % confidence.
inline constexpr int freshPartCount = 500;

/// The project with a batch of this many parts, drawn at random and independently; each `draw` from
/// 1 on gives different parts, and none gives those of the batch itself.
[[nodiscard]] Project withFreshParts(Project project, int draw, int count = freshPartCount);

} // namespace sparkout
