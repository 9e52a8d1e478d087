// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/scenario_source.h"

#include "core/cholesky.h"
#include "core/process/compliance.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/project/batch.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

FactorEnds truncation(const GivenFactor& factor) {
    FactorEnds ends{factor.allowed.low, factor.allowed.high};
    if (factor.law.within) {
        ends.low = std::max(ends.low, (*factor.law.within)[0]);
        ends.high = std::min(ends.high, (*factor.law.within)[1]);
    }
    return ends;
}

double triangularQuantile(const std::vector<double>& corners, double share) {
    const double a = corners[0], c = corners[1], b = corners[2];
    return share * (b - a) < c - a ? a + std::sqrt(share * (b - a) * (c - a))
                                   : b - std::sqrt((1 - share) * (b - a) * (b - c));
}

/// The share of a triangular law below a value: the inverse of its quantile.
double triangularShare(const std::vector<double>& corners, double value) {
    const double a = corners[0], c = corners[1], b = corners[2];
    if (b == a) {
        return 0.5;
    }
    const double share = value < c ? (value - a) * (value - a) / ((b - a) * (c - a))
                         : b == c  ? 1
                                   : 1 - (b - value) * (b - value) / ((b - a) * (b - c));
    return std::clamp(share, 0.0, 1.0);
}

} // namespace

double factorQuantile(const GivenFactor& factor, double share) {
    if (factor.law.uniform) {
        const auto& ends = *factor.law.uniform;
        return ends[0] + share * (ends[1] - ends[0]);
    }
    if (factor.law.triangular) {
        return triangularQuantile(*factor.law.triangular, share);
    }
    if (const auto& values = factor.law.measured) {
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(values->size()));
        return (*values)[std::min(rank, values->size() - 1)];
    }
    const double m = (*factor.law.normal)[0], s = (*factor.law.normal)[1];
    const FactorEnds ends = truncation(factor);
    if (s == 0) {
        return std::clamp(m, ends.low, ends.high);
    }
    const double below = normalShare((ends.low - m) / s), upTo = normalShare((ends.high - m) / s);
    const double p = std::clamp(below + share * (upTo - below), 0x1p-60, 1 - 0x1p-53);
    return std::clamp(m + s * normalQuantile(p), ends.low, ends.high);
}

double factorRank(const GivenFactor& factor, double value) {
    const auto between = [value](double low, double high) {
        return high == low ? 0.5 : std::clamp((value - low) / (high - low), 0.0, 1.0);
    };
    const Factor& law = factor.law;
    if (law.grows) {
        return between(std::min((*law.grows)[0], (*law.grows)[1]),
                       std::max((*law.grows)[0], (*law.grows)[1]));
    }
    if (law.uniform) {
        return between((*law.uniform)[0], (*law.uniform)[1]);
    }
    if (law.triangular) {
        return triangularShare(*law.triangular, value);
    }
    if (law.measured) {
        const auto [first, end] =
            std::equal_range(law.measured->begin(), law.measured->end(), value);
        return static_cast<double>((first - law.measured->begin()) + (end - law.measured->begin()))
               / (2 * static_cast<double>(law.measured->size()));
    }
    const double m = (*law.normal)[0], s = (*law.normal)[1];
    const FactorEnds ends = truncation(factor);
    if (s == 0) {
        return 0.5;
    }
    const double below = normalShare((ends.low - m) / s), upTo = normalShare((ends.high - m) / s);
    return upTo > below
               ? std::clamp((normalShare((value - m) / s) - below) / (upTo - below), 0.0, 1.0)
               : 0.5;
}

double lawValue(const GivenFactor& factor, std::int64_t part, std::int64_t parts) {
    const std::int64_t between = factor.law.parts_between_dressings.value_or(
        static_cast<int>(std::min<std::int64_t>(parts, std::numeric_limits<int>::max())));
    std::int64_t at = part % between, last = between - 1;
    if (factor.kind == FactorKind::wheelDiameter && factor.law.parts_between_dressings) {
        at = part / between;
        last = (parts - 1) / between;
    }
    const auto& ends = *factor.law.grows;
    const double share = last > 0 ? static_cast<double>(at) / static_cast<double>(last) : 0;
    return ends[0] + share * (ends[1] - ends[0]);
}

double factorMiddle(const GivenFactor& factor) {
    return factor.isLaw() ? (factor.law.grows->front() + factor.law.grows->back()) / 2
                          : factorQuantile(factor, 0.5);
}

FactorEnds cornerEnds(const GivenFactor& factor) {
    if (!factor.law.normal) {
        const Factor& law = factor.law;
        const auto& ends = law.uniform      ? *law.uniform
                           : law.triangular ? *law.triangular
                           : law.measured   ? *law.measured
                                            : *law.grows;
        const bool isTurn = factor.kind == FactorKind::wheelPhase; // whose ends are one angle
        return {ends.front(), isTurn ? (ends.front() + ends.back()) / 2 : ends.back()};
    }
    const double m = (*factor.law.normal)[0], s = (*factor.law.normal)[1];
    const FactorEnds ends = truncation(factor);
    return factor.law.within
               ? ends
               : FactorEnds{std::max(m - 3 * s, ends.low), std::min(m + 3 * s, ends.high)};
}

std::optional<double> replacedValue(FactorKind kind, const Project& project) {
    const Part& part = *project.part;
    switch (kind) {
    case FactorKind::stock: return part.stock_mm;
    case FactorKind::runout:
        return part.profile == ProfileForm::measured ? std::nullopt
                                                     : std::optional(part.initial_runout_mm);
    case FactorKind::dullness: return dullnessOf(*project.wheel);
    case FactorKind::wheelDiameter: return project.wheel->diameter_mm;
    case FactorKind::flowStress: return project.material->flow_stress_mpa;
    case FactorKind::contactWidth:
        return project.operation->travels ? project.wheel->width_mm : part.length_mm;
    case FactorKind::partWarmer: return project.gauge->part_warmer_k;
    case FactorKind::compliance:
    case FactorKind::machineForm:
    case FactorKind::runoutAt:
    case FactorKind::wheelPhase:
    case FactorKind::gaugeError:
    case FactorKind::gaugeAge: break;
    }
    return std::nullopt;
}

void putFactor(const GivenFactor& factor, double value, Project& project) {
    if (factor.place < 0) {
        putFactor(factor.kind, value, project);
        return;
    }
    auto& own = factor.kind == FactorKind::stock    ? project.part->zone_stock_mm
                : factor.kind == FactorKind::runout ? project.part->zone_runout_mm
                                                    : project.machine->zone_compliance;
    if (!own) {
        const double same = factor.kind == FactorKind::compliance ? 1 : 0;
        own.emplace(static_cast<std::size_t>(placeCount(project)), same);
    }
    own->at(static_cast<std::size_t>(factor.place)) = value;
}

void putFactor(FactorKind kind, double value, Project& project) {
    switch (kind) {
    case FactorKind::stock: project.part->stock_mm = value; break;
    case FactorKind::runout:
        if (project.part->profile == ProfileForm::measured) {
            const double runout = initialRunout(*project.part);
            for (double& radius : *project.part->radii_um) {
                radius *= runout > 0 ? value / runout : 1;
            }
        }
        project.part->initial_runout_mm = value;
        break;
    case FactorKind::dullness: setDullness(*project.wheel, value); break;
    case FactorKind::wheelDiameter: changeWheelDiameter(project, value); break;
    case FactorKind::flowStress: project.material->flow_stress_mpa = value; break;
    case FactorKind::compliance: scaleCompliance(project, value); break;
    case FactorKind::machineForm:
        if (!project.machine->form) {
            project.machine->geometric_runout_um *= value;
            break;
        }
        for (auto* const own :
             {&project.machine->form->roundness_um, &project.machine->form->runout_um}) {
            for (std::size_t i = 0; *own && i < (*own)->size(); ++i) {
                (**own)[i] *= value;
            }
        }
        break;
    case FactorKind::runoutAt: project.machine->form->runout_at_deg = value; break;
    case FactorKind::wheelPhase: project.wheel->runout->phase_deg = value; break;
    case FactorKind::gaugeError:
        project.gauge->error_um += value * project.machine->gauge_repeatability_um.value_or(0);
        break;
    case FactorKind::gaugeAge:
        project.gauge->error_um += value * project.machine->gauge_drift_um_h.value_or(0);
        break;
    case FactorKind::partWarmer: project.gauge->part_warmer_k = value; break;
    case FactorKind::contactWidth:
        (project.operation->travels ? project.wheel->width_mm : project.part->length_mm) = value;
        break;
    }
}

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
