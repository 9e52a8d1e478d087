// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/scenario_source.h"

#include "core/cholesky.h"
#include "core/process/profile.h"
#include "core/project/batch.h"
#include "core/project/gauge.h"
#include "core/quality/roughness.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "core/statistics/sobol_sequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sparkout {

std::optional<Correlation> Correlation::of(const std::vector<std::vector<double>>& matrix) {
    auto lower = choleskyFactor(matrix);
    if (!lower) {
        return std::nullopt;
    }
    Correlation found;
    found.m_lower = std::move(*lower);
    return found;
}

void Correlation::apply(std::span<double> shares) const {
    std::vector<double> scores;
    for (const double share : shares) {
        scores.push_back(normalQuantile(share));
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double score = 0;
        for (std::size_t k = 0; k <= i; ++k) {
            score += m_lower[i][k] * scores[k];
        }
        shares[i] = std::clamp(normalShare(score), 0x1p-60, 1 - 0x1p-53);
    }
}

ScenarioSource::ScenarioSource(Project project)
    : m_nominal(withMeasuredRa(std::move(project))), m_batch(m_nominal.batch.value_or(Batch{})) {
    m_factors = scatteredFactors(m_nominal);
    m_ofPart = givenFactors(m_nominal).size();
    m_constants = zoneConstants(m_nominal);
    if (Gauge& gauge = *m_nominal.gauge; gauge.control == Control::position && !gauge.datum_mm) {
        gauge.datum_mm = makeBlank(*m_nominal.part).totalInfeed_mm;
    }
    m_nominal.batch.reset();
    m_nominal.optimisation.reset();
    m_nominal.sweep.reset();
    m_nominal.runs.clear();
    if (m_batch.correlation) {
        m_correlation = Correlation::of(*m_batch.correlation);
    }
    m_hasLaw = std::any_of(m_factors.begin(), m_factors.end(),
                           [](const GivenFactor& factor) { return factor.isLaw(); });
    m_isSample = m_batch.scenarios != Scenarios::corners && !m_factors.empty();
    if (m_isSample) {
        m_parts = m_batch.parts;
    } else {
        m_parts = cornerCount(m_factors);
    }
}

double ScenarioSource::share(std::int64_t part, std::size_t factor) const {
    const std::uint32_t seed = this->seed();
    const auto f = static_cast<std::uint32_t>(factor);
    const auto i = static_cast<std::uint64_t>(part), N = static_cast<std::uint64_t>(m_parts);
    if (m_batch.scenarios == Scenarios::sobol) {
        constexpr std::uint32_t orderOfPoints = 1000; // a permutation that no factor uses
        const auto point =
            static_cast<std::uint32_t>(m_hasLaw ? permuted(i, N, seed, orderOfPoints) : i);
        const auto shift =
            static_cast<std::uint32_t>(randomBits(seed, RandomStream::shift, 0, f) >> 32);
        const std::uint32_t x = sobolCoordinate(point, static_cast<int>(factor)) ^ shift;
        return (x + 0.5) * 0x1p-32;
    }
    if (m_batch.scenarios == Scenarios::random) {
        return openUnit(randomBits(seed, RandomStream::plain, i, f));
    }
    const double within = openUnit(randomBits(seed, RandomStream::jitter, i, f));
    const double u =
        (static_cast<double>(permuted(i, N, seed, f)) + within) / static_cast<double>(N);
    return std::min(u, 1 - 0x1p-53);
}

std::vector<double> ScenarioSource::values(std::int64_t part) const {
    std::vector<double> values(m_factors.size());
    if (!m_isSample) {
        int bit = 0;
        for (std::size_t f = 0; f < values.size(); ++f) {
            if (isOfReading(m_factors[f].kind)) {
                values[f] = factorMiddle(m_factors[f]);
                continue;
            }
            const FactorEnds ends = cornerEnds(m_factors[f]);
            values[f] = (part >> bit++ & 1) != 0 ? ends.high : ends.low;
        }
        return values;
    }
    for (std::size_t f = 0; f < values.size(); ++f) {
        values[f] = share(part, f);
    }
    if (m_correlation) {
        m_correlation->apply({values.data(), m_ofPart});
    }
    for (std::size_t f = 0; f < values.size(); ++f) {
        values[f] = m_factors[f].isLaw() ? lawValue(m_factors[f], part, m_parts)
                                         : factorQuantile(m_factors[f], values[f]);
    }
    return values;
}

Project ScenarioSource::project(std::int64_t part) const {
    return projectWith(values(part));
}

Project ScenarioSource::projectWith(const std::vector<double>& values) const {
    Project project = m_nominal;
    for (const GivenFactor& constant : m_constants) {
        putFactor(constant, constant.law.uniform->front(), project);
    }
    for (std::size_t f = 0; f < values.size(); ++f) {
        putFactor(m_factors[f], values[f], project);
    }
    return project;
}

RankScores ScenarioSource::scores(const std::vector<double>& values) const {
    RankScores scores{};
    for (std::size_t f = 0; f < values.size(); ++f) {
        const double centred = factorRank(m_factors[f], values[f]) - 0.5;
        scores[f] = static_cast<std::int32_t>(std::lround(std::ldexp(centred, rankScoreBits)));
    }
    return scores;
}

Project withFreshParts(Project project, int draw, int count) {
    constexpr unsigned mostSeed = std::numeric_limits<int>::max(), apart = 1'000'003;
    Batch& batch = *project.batch;
    const unsigned seed = static_cast<unsigned>(batch.seed) + apart * static_cast<unsigned>(draw);
    batch.seed = static_cast<int>(seed & mostSeed);
    batch.scenarios = Scenarios::random;
    batch.parts = count;
    return project;
}

} // namespace sparkout
