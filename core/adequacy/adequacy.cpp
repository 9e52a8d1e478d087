// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/adequacy/adequacy.h"

#include "core/batch/moments.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

MeanPlace placeOfMean(const Interval& mean, const PredictedRange& range) {
    // A prediction that does not scatter is one value: inside when the interval holds it.
    const bool isOne = range.low == range.high && mean.low <= range.low && mean.high >= range.high;
    if (isOne || (mean.low >= range.low && mean.high <= range.high)) {
        return MeanPlace::inside;
    }
    return mean.high < range.low   ? MeanPlace::below
           : mean.low > range.high ? MeanPlace::above
                                   : MeanPlace::undecided;
}

/// A summary tells it only if its extremes do.
std::optional<InsideShare> shareInside(const MeasuredStatistics& measured,
                                       const PredictedRange& range) {
    InsideShare share;
    share.count = measured.count;
    if (!measured.isSummary) {
        share.inside = std::ranges::count_if(measured.values, [&range](double value) {
            return value >= range.low && value <= range.high;
        });
    } else if (measured.least && measured.greatest && *measured.least >= range.low
               && *measured.greatest <= range.high) {
        share.inside = measured.count;
    } else {
        return std::nullopt;
    }
    share.interval = clopperPearson(share.inside, share.count, confidence95);
    return share;
}

AdequacyVerdict verdictOf(const AdequacyRow& row) {
    const bool scatters = row.scatter && row.scatter->differs();
    switch (row.meanPlace) {
    case MeanPlace::below:
    case MeanPlace::above:
        return scatters ? AdequacyVerdict::biasedAndScatters : AdequacyVerdict::biased;
    case MeanPlace::inside:
        return scatters ? AdequacyVerdict::scatterDiffers : AdequacyVerdict::adequate;
    case MeanPlace::undecided: break;
    }
    return scatters ? AdequacyVerdict::scatterDiffers : AdequacyVerdict::tooFewParts;
}

} // namespace

AdequacyRow judgeAdequacy(MeasuredStatistics measured, std::optional<PredictedRange> predicted) {
    AdequacyRow row;
    row.measured = std::move(measured);
    row.predicted = predicted;
    const MeasuredStatistics& parts = row.measured;
    const bool hasScatter = parts.deviation && parts.count >= 2;
    if (hasScatter) {
        row.mean95 = studentInterval(parts.mean, *parts.deviation, parts.count, confidence95);
    }
    if (!predicted) {
        return row;
    }
    row.share = shareInside(parts, *predicted);
    if (row.mean95) {
        row.meanPlace = placeOfMean(*row.mean95, *predicted);
    }
    if (hasScatter && predicted->deviation && predicted->count >= 2) {
        row.scatter = varianceRatio(*parts.deviation, parts.count, *predicted->deviation,
                                    predicted->count, confidence95);
        row.bias95 =
            welchInterval({parts.mean, *parts.deviation, parts.count},
                          {predicted->mean, *predicted->deviation, predicted->count}, confidence95);
    }
    row.verdict = verdictOf(row);
    return row;
}

std::vector<AdequacyRow> judgeAdequacy(const Project& project, const BatchResult& batch) {
    std::vector<AdequacyRow> rows;
    for (MeasuredStatistics& measured : statisticsOfMeasured(project)) {
        const auto range = predicted(batch, measured.quantity, measured.place);
        rows.push_back(judgeAdequacy(std::move(measured), range));
    }
    return rows;
}

bool speaksForModel(const std::vector<AdequacyRow>& rows) {
    return std::ranges::all_of(rows, [](const AdequacyRow& row) {
        return row.verdict == AdequacyVerdict::adequate
               || row.verdict == AdequacyVerdict::tooFewParts
               || row.verdict == AdequacyVerdict::notPredicted;
    });
}

} // namespace sparkout
