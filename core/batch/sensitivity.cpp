// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/sensitivity.h"

#include "core/batch/worker_pool.h"
#include "core/project/batch.h"
#include "core/simulation/simulate.h"
#include "core/statistics/philox.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sparkout {

namespace {

/// Ranks less their mean, equal values sharing theirs.
Eigen::VectorXd centredRanks(const std::vector<double>& values) {
    const std::size_t n = values.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    Eigen::VectorXd ranks(static_cast<Eigen::Index>(n));
    for (std::size_t first = 0; first < n;) {
        std::size_t end = first;
        while (end < n && values[order[end]] == values[order[first]]) {
            ++end;
        }
        const double shared = static_cast<double>(first + end - 1) / 2;
        for (; first < end; ++first) {
            ranks[static_cast<Eigen::Index>(order[first])] =
                shared - static_cast<double>(n - 1) / 2;
        }
    }
    return ranks;
}

/// The least number of parts for a regression on this many factors.
std::size_t leastParts(std::size_t factors) {
    return 2 * factors + 2;
}

// b = R⁻¹·r with the correlations R between the factors' ranks and r with the characteristic's;
// R² = bᵀ·r.
std::optional<RankRegression> regression(const std::vector<std::vector<double>>& factors,
                                         const std::vector<double>& values) {
    const auto k = static_cast<Eigen::Index>(factors.size());
    const Eigen::VectorXd y = centredRanks(values);
    if (k == 0 || values.size() < leastParts(factors.size()) || y.squaredNorm() == 0) {
        return std::nullopt;
    }
    Eigen::MatrixXd X(y.size(), k);
    for (Eigen::Index f = 0; f < k; ++f) {
        X.col(f) = centredRanks(factors[static_cast<std::size_t>(f)]);
        const double size = X.col(f).norm();
        if (size == 0) {
            return std::nullopt;
        }
        X.col(f) /= size;
    }
    const Eigen::VectorXd r = X.transpose() * y / y.norm();
    const Eigen::VectorXd b = (X.transpose() * X).ldlt().solve(r);
    if (!b.allFinite()) {
        return std::nullopt;
    }
    return RankRegression{{b.data(), b.data() + k}, b.dot(r)};
}

/// The mean rank of each bin's values, relative to the overall mean rank.
std::vector<double> centredRanksOf(const ValueBins& bins, std::int64_t count) {
    std::vector<double> ranks;
    std::int64_t before = 0;
    for (const auto& [number, bin] : bins.bins()) {
        ranks.push_back(static_cast<double>(2 * before + bin.count - count) / 2);
        before += bin.count;
    }
    return ranks;
}

// The regression over the whole batch, by the ranks y_b of the characteristic's bins and the scores
// s of the factors. Σy·s_j = Σ_b y_b·S_j(b), S_j(b) the sum of the scores of a bin's parts;
// Σs_i·s_j less the means' part is stored.
std::optional<RankRegression> binnedRegression(const ValueStatistics& values, std::size_t factors) {
    const auto k = static_cast<Eigen::Index>(factors);
    const auto n = static_cast<double>(values.count);
    if (k == 0 || values.count < static_cast<std::int64_t>(leastParts(factors))) {
        return std::nullopt;
    }
    const std::vector<double> ranks = centredRanksOf(values.bins, values.count);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(k), r = Eigen::VectorXd::Zero(k);
    double size = 0;
    auto rank = ranks.begin();
    for (const auto& [number, bin] : values.bins.bins()) {
        size += *rank * *rank * static_cast<double>(bin.count);
        for (Eigen::Index f = 0; f < k; ++f) {
            const auto score = static_cast<double>(bin.scores[static_cast<std::size_t>(f)]);
            sums[f] += score;
            r[f] += *rank * score;
        }
        ++rank;
    }
    Eigen::MatrixXd R(k, k);
    for (Eigen::Index i = 0; i < k; ++i) {
        for (Eigen::Index j = i; j < k; ++j) {
            const auto product = static_cast<double>(values.products[productPlace(
                static_cast<std::size_t>(i), static_cast<std::size_t>(j))]);
            R(i, j) = R(j, i) = product - sums[i] * sums[j] / n;
        }
    }
    const Eigen::VectorXd sizes = R.diagonal().cwiseMax(0).cwiseSqrt();
    if (size == 0 || sizes.minCoeff() == 0) {
        return std::nullopt;
    }
    r = r.cwiseQuotient(sizes) / std::sqrt(size);
    R = sizes.cwiseInverse().asDiagonal() * R * sizes.cwiseInverse().asDiagonal();
    const Eigen::VectorXd b = R.ldlt().solve(r);
    if (!b.allFinite()) {
        return std::nullopt;
    }
    return RankRegression{{b.data(), b.data() + k}, b.dot(r)};
}

/// The points of the two independent samples A and B and of their mixtures.
class SobolDesign {
public:
    SobolDesign(const ScenarioSource& source, int points, std::uint32_t seed)
        : m_source(source), m_points(points), m_seed(seed), m_factors(source.factors().size()) {}

    [[nodiscard]] std::int64_t size() const {
        return std::int64_t{m_points} * static_cast<std::int64_t>(m_factors + 2);
    }

    /// Run number `index`: point index/(k+2) of A, B, or A with one factor of B.
    [[nodiscard]] Project project(std::int64_t index) const {
        const auto runs = static_cast<std::int64_t>(m_factors + 2);
        const auto point = static_cast<std::uint32_t>(index / runs);
        const auto which = static_cast<std::size_t>(index % runs);
        std::vector<double> values(m_factors);
        for (std::size_t f = 0; f < m_factors; ++f) {
            const bool ofB = which == 1 || which == f + 2;
            values[f] = value(f, point, ofB ? f + m_factors : f);
        }
        return m_source.projectWith(values);
    }

private:
    [[nodiscard]] double value(std::size_t factor, std::uint32_t point,
                               std::size_t dimension) const {
        const auto shift = static_cast<std::uint32_t>(
            randomBits(m_seed, RandomStream::shift, 1, static_cast<std::uint32_t>(dimension))
            >> 32);
        static_assert(2 * limits::factors <= sobolDimensions); // dimensions of A and of B
        const std::uint32_t x = sobolCoordinate(point, static_cast<int>(dimension)) ^ shift;
        const double share = (x + 0.5) * 0x1p-32;
        const GivenFactor& given = m_source.factors()[factor];
        if (!given.isLaw()) {
            return factorQuantile(given, share);
        }
        const FactorEnds ends = cornerEnds(given);
        return ends.low + share * (ends.high - ends.low);
    }

    const ScenarioSource& m_source;
    int m_points;
    std::uint32_t m_seed;
    std::size_t m_factors;
};

// S_i = ⟨f_B·(f_ABi − f_A)⟩/V, T_i = ⟨(f_A − f_ABi)²⟩/(2V), with the mean of A and B subtracted
// from f to reduce rounding.
std::vector<SobolIndex> indicesOf(const std::vector<double>& f, std::size_t factors) {
    const std::size_t runs = factors + 2, points = f.size() / runs;
    double mean = 0, variance = 0;
    for (std::size_t p = 0; p < points; ++p) {
        mean += (f[p * runs] + f[p * runs + 1]) / static_cast<double>(2 * points);
    }
    for (std::size_t p = 0; p < points; ++p) {
        const double a = f[p * runs] - mean, b = f[p * runs + 1] - mean;
        variance += (a * a + b * b) / static_cast<double>(2 * points);
    }
    if (!(variance > 0)) { // false also for NaN, when a part has no value
        return {};
    }
    std::vector<SobolIndex> found(factors);
    for (std::size_t i = 0; i < factors; ++i) {
        for (std::size_t p = 0; p < points; ++p) {
            const double a = f[p * runs] - mean, b = f[p * runs + 1] - mean;
            const double mixed = f[p * runs + 2 + i] - mean;
            found[i].first += b * (mixed - a);
            found[i].total += (a - mixed) * (a - mixed) / 2;
        }
        found[i].first /= variance * static_cast<double>(points);
        found[i].total /= variance * static_cast<double>(points);
        if (std::isnan(found[i].first)) {
            return {};
        }
    }
    return found;
}

} // namespace

std::vector<std::optional<RankRegression>> rankRegressions(const BatchResult& result) {
    const ScenarioSource source(result.project);
    const std::size_t count = result.statistics.values.size();
    const bool keepsAll = result.statistics.keepsAll();
    std::vector<std::optional<RankRegression>> found;
    for (std::size_t c = 0; c < count; ++c) {
        if (!keepsAll) {
            found.push_back(binnedRegression(result.statistics.values[c], source.factors().size()));
            continue;
        }
        std::vector<std::vector<double>> factors(source.factors().size());
        std::vector<double> values;
        for (const PartRow& row : result.statistics.rows) {
            if (!std::isfinite(row.values[c])) {
                continue;
            }
            values.push_back(row.values[c]);
            const std::vector<double> of = source.values(row.part);
            for (std::size_t f = 0; f < of.size(); ++f) {
                factors[f].push_back(of[f]);
            }
        }
        found.push_back(regression(factors, values));
    }
    return found;
}

std::optional<SobolIndices> sobolIndices(const Project& project, int points,
                                         const BatchOptions& options) {
    if (points < 1 || !project.batch || project.batch->correlation) {
        return std::nullopt;
    }
    const ScenarioSource source(project);
    if (source.factors().empty()) {
        return std::nullopt;
    }
    const SobolDesign design(source, points, static_cast<std::uint32_t>(project.batch->seed));
    const auto characteristics = characteristicsOf(source.nominal());
    const auto size = static_cast<std::size_t>(design.size());
    std::vector<std::vector<double>> values(
        characteristics.size(),
        std::vector<double>(size, std::numeric_limits<double>::quiet_NaN()));
    forEachIndex(workerCount(options.threads), 0, design.size(), options.stop,
                 [&](std::size_t, std::int64_t index) {
                     PartOutcome outcome;
                     measure(simulateUnchecked(design.project(index), nullptr, options.stop),
                             characteristics, outcome);
                     for (std::size_t c = 0; c < outcome.values.size(); ++c) {
                         values[c][static_cast<std::size_t>(index)] = outcome.values[c];
                     }
                     if (options.done) {
                         options.done->fetch_add(1, std::memory_order_relaxed);
                     }
                     return true;
                 });
    if (options.stop.stop_requested()) {
        return std::nullopt;
    }
    SobolIndices found{design.size(), {}};
    for (const std::vector<double>& of : values) {
        found.byCharacteristic.push_back(indicesOf(of, source.factors().size()));
    }
    return found;
}

} // namespace sparkout
