// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_summary.h"

#include "core/project/batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr std::array percentileOrders{0.00135, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 0.99865};
/// Scatter below this share of the resolution is rounding and gives no capability.
constexpr double negligible = 1e-6;
constexpr double mostIndex = 99; ///< above it the scatter is negligible
constexpr std::int64_t leastForShape = 20;
constexpr std::int64_t mostBars = 40;

Share shareOf(std::int64_t count, std::int64_t parts, bool isSample) {
    Share share{count, 0, {}};
    if (parts > 0) {
        share.value = static_cast<double>(count) / static_cast<double>(parts);
        if (isSample) {
            share.interval = clopperPearson(count, parts, confidence95);
        }
    }
    return share;
}

/// The number of parts with strips uncut.
std::int64_t strippedOf(const BatchStatistics& statistics) {
    return statistics.rejects[static_cast<std::size_t>(ConstraintKind::overlap)];
}

class Summariser {
public:
    Summariser(const BatchResult& result, bool isSample)
        : m_statistics(result.statistics), m_isSample(isSample), m_exact(m_statistics.keepsAll()) {}

    [[nodiscard]] bool exact() const { return m_exact; }

    CharacteristicSummary of(const Characteristic& characteristic, std::size_t index) {
        const ValueStatistics& values = m_statistics.values[index];
        CharacteristicSummary summary;
        summary.characteristic = characteristic;
        summary.count = values.count;
        summary.unstated = isOfSurface(characteristic) ? strippedOf(m_statistics) : 0;
        summary.least = values.least;
        summary.most = values.most;
        summary.moments = momentsOf(values);
        summary.outside = shareOf(values.below + values.above, values.count, m_isSample);
        if (values.count == 0) {
            return summary;
        }
        summary.histogram = histogram(values.bins.atLeast(ValueBins::levelOfResolution),
                                      characteristic.resolution, values.count);
        sortValues(index);
        for (const double order : percentileOrders) {
            summary.percentiles.push_back(percentile(values, characteristic.resolution, order));
        }
        if (m_isSample && values.count >= 2) {
            addEstimates(summary, values);
        }
        return summary;
    }

private:
    /// The kept values in order, when all parts are kept.
    void sortValues(std::size_t index) {
        m_sorted.clear();
        for (std::size_t i = 0; m_exact && i < m_statistics.rows.size(); ++i) {
            const double value = m_statistics.rows[i].values[index];
            if (std::isfinite(value)) {
                m_sorted.push_back(value);
            }
        }
        std::sort(m_sorted.begin(), m_sorted.end());
    }

    /// The value of a rank, counted from 1, or the bin that contains it.
    [[nodiscard]] Interval ranked(const ValueStatistics& values, double resolution,
                                  std::int64_t rank) const {
        if (static_cast<std::int64_t>(m_sorted.size()) == values.count) {
            const double value = m_sorted[static_cast<std::size_t>(rank - 1)];
            return {value, value};
        }
        const auto within = [&values](double value) {
            return std::clamp(value, values.least.value, values.most.value);
        };
        const double width = values.bins.width(resolution);
        std::int64_t below = 0;
        for (const auto& [number, bin] : values.bins.bins()) {
            below += bin.count;
            if (below >= rank) {
                const double low = static_cast<double>(number) * width;
                return {within(low), within(low + width)};
            }
        }
        return {values.most.value, values.most.value};
    }

    [[nodiscard]] Percentile percentile(const ValueStatistics& values, double resolution,
                                        double order) const {
        const auto exactRank = order * static_cast<double>(values.count);
        const auto rank = std::clamp<std::int64_t>(
            static_cast<std::int64_t>(std::ceil(exactRank - 1e-9)), 1, values.count);
        const Interval at = ranked(values, resolution, rank);
        Percentile found{order, at.low + (at.high - at.low) / 2, {}};
        const auto ranks =
            m_isSample ? quantileRanks(values.count, order, confidence95) : std::optional<Ranks>();
        if (ranks) {
            found.interval = Interval{ranked(values, resolution, ranks->low).low,
                                      ranked(values, resolution, ranks->high).high};
        }
        return found;
    }

    /// At most √n bars and no more than 40, each with the same number of bins.
    static std::vector<HistogramBar> histogram(const ValueBins& bins, double resolution,
                                               std::int64_t count) {
        const std::int64_t first = bins.bins().begin()->first, last = bins.bins().rbegin()->first;
        const double binWidth = bins.width(resolution);
        const auto root =
            static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        const std::int64_t bars = std::clamp<std::int64_t>(root, 5, mostBars);
        const std::int64_t width = (last - first) / bars + 1;
        std::vector<HistogramBar> found(static_cast<std::size_t>((last - first) / width + 1));
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto low = static_cast<double>(first + static_cast<std::int64_t>(i) * width);
            found[i].low = low * binWidth;
            found[i].high = (low + static_cast<double>(width)) * binWidth;
        }
        for (const auto& [number, bin] : bins.bins()) {
            found[static_cast<std::size_t>((number - first) / width)].count += bin.count;
        }
        return found;
    }

    void addEstimates(CharacteristicSummary& summary, const ValueStatistics& values) const {
        const Characteristic& of = summary.characteristic;
        const double s = summary.moments.deviation, mean = summary.moments.mean;
        summary.mean95 = studentInterval(mean, s, summary.count, confidence95);
        if (s <= negligible * of.resolution) {
            return;
        }
        if (summary.count >= leastForShape) {
            summary.normality =
                static_cast<std::int64_t>(m_sorted.size()) == summary.count
                    ? shapiroWilk(m_sorted)
                    : andersonDarling(values.bins, of.resolution, summary.count, mean, s);
        }
        addCapability(summary);
    }

    const BatchStatistics& m_statistics;
    bool m_isSample, m_exact;
    std::vector<double> m_sorted;
};

/// Ppk, or the greatest number if it was not computed.
double leastPpk(const CharacteristicSummary& summary) {
    return summary.ppk ? summary.ppk->value : std::numeric_limits<double>::max();
}

std::vector<RejectCause> causesOf(const BatchStatistics& statistics) {
    std::vector<RejectCause> causes{{std::nullopt, statistics.failed}};
    for (std::size_t i = 0; i < statistics.rejects.size(); ++i) {
        causes.push_back({static_cast<ConstraintKind>(i), statistics.rejects[i]});
    }
    std::erase_if(causes, [](const RejectCause& cause) { return cause.count == 0; });
    std::stable_sort(causes.begin(), causes.end(),
                     [](const RejectCause& a, const RejectCause& b) { return a.count > b.count; });
    return causes;
}

constexpr std::int64_t leastForCapability = 2;

/// Index of the characteristic with the greatest value of a figure; empty where none has it.
template <class Figure>
std::optional<std::size_t> greatest(const BatchSummary& summary, Figure figure) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        const std::optional<double> value = figure(summary.characteristics[i]);
        if (value && (!found || *value > *figure(summary.characteristics[*found]))) {
            found = i;
        }
    }
    return found;
}

/// Judges the forecast for further parts.
BatchVerdict weighExpected(const BatchSummary& summary, const Batch& limits) {
    const auto outside =
        greatest(summary, [](const CharacteristicSummary& of) { return of.expectedOutside; });
    if (limits.most_outside_share && outside) {
        const double share = *summary.characteristics[*outside].expectedOutside;
        if (share > *limits.most_outside_share) {
            return {Fitness::conditional, BatchReason::outside, outside, share,
                    *limits.most_outside_share};
        }
    }
    const auto least = greatest(summary, [](const CharacteristicSummary& of) {
        return of.ppk ? std::optional(-of.ppk->interval.low) : std::nullopt;
    });
    const double bound = least ? summary.characteristics[*least].ppk->interval.low : 0;
    if (least && bound < limits.least_ppk) {
        return {Fitness::conditional, BatchReason::ppk, least, bound, limits.least_ppk};
    }
    return {Fitness::fit, BatchReason::allHold, least, bound, limits.least_ppk};
}

} // namespace

// P_p = (U − L)/(6s), P_pk = min(U − mean, mean − L)/(3s); with one limit only P_pk.
void addCapability(CharacteristicSummary& summary) {
    const Characteristic& of = summary.characteristic;
    const double s = summary.moments.deviation, mean = summary.moments.mean;
    if (!hasCapability(of) || summary.unstated > 0 || summary.count < 2
        || s <= negligible * of.resolution) {
        return;
    }
    const double above = of.high ? *of.high - mean : std::numeric_limits<double>::max();
    const double under = of.low ? mean - *of.low : std::numeric_limits<double>::max();
    const double ppk = std::min(above, under) / (3 * s);
    if (ppk > mostIndex) {
        return;
    }
    summary.ppk = Estimate{ppk, ppkInterval(ppk, summary.count, confidence95)};
    if (of.low && of.high) {
        const double pp = (*of.high - *of.low) / (6 * s);
        summary.pp = Estimate{pp, ppInterval(pp, summary.count, confidence95)};
    }
    summary.expectedOutside =
        (of.high ? normalShare(-above / s) : 0) + (of.low ? normalShare(-under / s) : 0);
}

BatchSummary summarise(const BatchResult& result) {
    const ScenarioSource source(result.project);
    const BatchStatistics& statistics = result.statistics;
    Summariser summariser(result, source.isSample());
    BatchSummary summary;
    summary.isSample = source.isSample();
    summary.parts = statistics.parts;
    summary.failed = statistics.failed;
    summary.stripped = strippedOf(statistics);
    summary.bad = shareOf(statistics.bad, statistics.parts, source.isSample());
    summary.causes = causesOf(statistics);
    summary.worstPart = statistics.worst.part;
    summary.exactPercentiles = summariser.exact();
    summary.drifts = std::ranges::any_of(source.factors(), &GivenFactor::isLaw);
    const std::vector<Characteristic> characteristics = characteristicsOf(source.nominal());
    for (std::size_t i = 0; i < statistics.values.size(); ++i) {
        summary.characteristics.push_back(summariser.of(characteristics[i], i));
    }
    return summary;
}

std::vector<std::size_t> placesOf(const BatchSummary& summary, const std::string& name,
                                  std::size_t most) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        if (name == summary.characteristics[i].characteristic.name) {
            places.push_back(i);
        }
    }
    if (places.size() > most) {
        std::ranges::stable_sort(
            places, {}, [&summary](std::size_t i) { return leastPpk(summary.characteristics[i]); });
        places.resize(most);
        std::ranges::sort(places);
    }
    return places;
}

BatchVerdict weigh(const BatchSummary& summary, const BatchResult& result) {
    const Batch limits = result.project.batch.value_or(Batch{});
    const double allowed = limits.most_outside_share.value_or(0);
    const auto by = [&](Fitness fitness, BatchReason reason) {
        return BatchVerdict{fitness, reason, {}, summary.bad.value, allowed};
    };
    if (summary.parts == 0) {
        return by(Fitness::unfit, BatchReason::noPart);
    }
    if (summary.bad.value > allowed) {
        return by(Fitness::unfit, BatchReason::partsFail);
    }
    if (summary.bad.count > 0) {
        return by(Fitness::conditional, BatchReason::someFail);
    }
    if (result.status == BatchStatus::stopped) {
        return by(Fitness::conditional, BatchReason::stopped);
    }
    if (!summary.isSample) {
        return by(Fitness::conditional, BatchReason::noSample);
    }
    if (summary.parts < leastForCapability) {
        return by(Fitness::conditional, BatchReason::fewParts);
    }
    return weighExpected(summary, limits);
}

} // namespace sparkout
