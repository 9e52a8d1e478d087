// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_verdict.h"

#include "core/project/batch.h"

namespace sparkout {

namespace {

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
