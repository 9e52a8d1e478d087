// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/factor_law.h"
#include "core/project/batch.h"
#include "core/project/project.h"
#include "core/statistics/value_bins.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sparkout {

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

/// The project with a batch of so many parts, drawn at random and independently; each `draw` from 1
/// on gives different parts, and none gives those of the batch itself.
[[nodiscard]] Project withFreshParts(Project project, int draw, int count = freshPartCount);

} // namespace sparkout
