// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/adequacy/prediction.h"

#include "core/batch/batch_statistics.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/quality/requirement.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace sparkout {

namespace {

bool isOf(const Characteristic& characteristic, MeasuredQuantity quantity, int place) {
    const Requirement* const row = characteristic.requirement;
    const auto is = [row](ConstraintKind kind) { return row && row->kind == kind; };
    const bool here = characteristic.section == place || characteristic.section < 0;
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation:
        return !row && characteristic.section == place && place >= 0;
    case MeasuredQuantity::radial_runout: return here && is(ConstraintKind::radialRunout);
    case MeasuredQuantity::roundness: return here && is(ConstraintKind::roundness);
    case MeasuredQuantity::cylindricity: return is(ConstraintKind::cylindricity);
    case MeasuredQuantity::roughness_ra: return here && is(ConstraintKind::roughness);
    }
    return false;
}

/// The least value of a rank whose share is at least `order`.
double quantileOf(const std::vector<double>& sorted, double order) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(order * static_cast<double>(sorted.size()) - 1e-9));
    return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

} // namespace

Quartiles quartilesOf(const std::vector<double>& sorted) {
    return {quantileOf(sorted, 0.25), quantileOf(sorted, 0.5), quantileOf(sorted, 0.75)};
}

Project predictingProject(Project project) {
    if (!project.batch) {
        project.batch.emplace();
    }
    constexpr double anyForm_um = 1000, anyRoughness_um = 100; // greatest values of a drawing
    Tolerance& tolerance = project.part->tolerance;
    tolerance.roundness_um = tolerance.roundness_um.value_or(anyForm_um);
    tolerance.cylindricity_um = tolerance.cylindricity_um.value_or(anyForm_um);
    tolerance.roughness_ra_um = tolerance.roughness_ra_um.value_or(anyRoughness_um);
    project.measured.reset();
    return project;
}

std::optional<PredictedRange> predicted(const BatchResult& batch, MeasuredQuantity quantity,
                                        int place) {
    const std::vector<Characteristic> all = characteristicsOf(batch.project);
    const auto found = std::ranges::find_if(
        all, [&](const Characteristic& one) { return isOf(one, quantity, place); });
    const auto index = static_cast<std::size_t>(found - all.begin());
    if (found == all.end() || index >= batch.statistics.values.size()
        || batch.statistics.values[index].count == 0) {
        return std::nullopt;
    }
    const ValueStatistics& values = batch.statistics.values[index];
    const Moments moments = momentsOf(values);
    PredictedRange range{values.least.value, values.most.value,  moments.mean,      {},
                         values.count,       values.least.value, values.most.value, {}};
    const bool isSample = batch.project.batch->scenarios != Scenarios::corners;
    // A scatter by rounding alone counts as none.
    if (!isSample || values.count < 2 || !(moments.deviation > found->resolution * 1e-6)) {
        return range;
    }
    range.deviation = moments.deviation;
    std::vector<double> sorted;
    for (const PartRow& row : batch.statistics.rows) {
        if (std::isfinite(row.values[index])) {
            sorted.push_back(row.values[index]);
        }
    }
    std::ranges::sort(sorted);
    constexpr double tail = (1 - confidence95) / 2;
    if (!sorted.empty()) {
        range.low = quantileOf(sorted, tail);
        range.high = quantileOf(sorted, 1 - tail);
        range.quartiles = quartilesOf(sorted);
    }
    return range;
}

} // namespace sparkout
