// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/value_bins.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

/// Numbers of bins at level 0, in both directions: 2²⁰ times the resolution.
constexpr std::int64_t outermost = std::int64_t{1} << (2 * ValueBins::levelOfResolution);

void addTo(ValueBins::Bin& bin, const ValueBins::Bin& other) {
    bin.count += other.count;
    for (std::size_t f = 0; f < factorKinds; ++f) {
        bin.scores[f] += other.scores[f];
    }
}

} // namespace

std::size_t ValueBins::mostFor(std::size_t characteristics) {
    constexpr std::size_t together = std::size_t{1} << 18; // some 30 MB a thread
    return std::clamp<std::size_t>(together / std::max<std::size_t>(characteristics, 1), 512, 4096);
}

void ValueBins::add(double value, double resolution, const RankScores& scores, std::size_t most) {
    const double at = std::floor(std::ldexp(value / resolution, levelOfResolution));
    constexpr auto limit = static_cast<double>(outermost);
    const auto finest = static_cast<std::int64_t>(std::clamp(at, -limit, limit));
    Bin& bin = m_bins[finest >> m_level];
    ++bin.count;
    for (std::size_t f = 0; f < factorKinds; ++f) {
        bin.scores[f] += scores[f];
    }
    while (m_bins.size() > most) {
        coarsen();
    }
}

void ValueBins::add(const ValueBins& other, std::size_t most) {
    while (m_level < other.m_level) {
        coarsen();
    }
    const int by = m_level - other.m_level;
    for (const auto& [number, bin] : other.m_bins) {
        addTo(m_bins[number >> by], bin);
    }
    while (m_bins.size() > most) {
        coarsen();
    }
}

ValueBins ValueBins::of(int level, Map bins) {
    ValueBins made;
    made.m_level = level;
    made.m_bins = std::move(bins);
    return made;
}

ValueBins ValueBins::atLeast(int level) const {
    ValueBins wide = *this;
    while (wide.m_level < level) {
        wide.coarsen();
    }
    return wide;
}

double ValueBins::width(double resolution) const {
    return std::ldexp(resolution, m_level - levelOfResolution);
}

std::int64_t ValueBins::lowest(int level) {
    return -outermost >> level;
}

std::int64_t ValueBins::highest(int level) {
    return outermost >> level;
}

/// Merges neighbouring pairs: numbers are halved, rounded down.
void ValueBins::coarsen() {
    Map wide;
    for (const auto& [number, bin] : m_bins) {
        addTo(wide.try_emplace(wide.end(), number >> 1)->second, bin);
    }
    m_bins = std::move(wide);
    ++m_level;
}

} // namespace sparkout
