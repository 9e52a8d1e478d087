// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/adequacy/measured_statistics.h"

#include "core/project/part.h"
#include "core/project/project.h"
#include "core/statistics/intervals.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

using Key = std::pair<MeasuredQuantity, int>;

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

int placeOf(MeasuredQuantity quantity, int place) {
    return quantity == MeasuredQuantity::cylindricity ? -1 : place;
}

MeasuredStatistics ofValues(const Key& key, std::vector<double> values) {
    MeasuredStatistics found;
    found.quantity = key.first;
    found.place = key.second;
    found.count = static_cast<std::int64_t>(values.size());
    std::ranges::sort(values);
    found.mean = meanOf(values);
    found.least = values.front();
    found.greatest = values.back();
    if (found.count >= 2) {
        const double squares =
            std::accumulate(values.begin(), values.end(), 0.0, [&found](double sum, double value) {
                return sum + (value - found.mean) * (value - found.mean);
            });
        found.deviation = std::sqrt(squares / static_cast<double>(found.count - 1));
    }
    found.values = std::move(values);
    return found;
}

// The interval of a mean is t·s/√n on either side, from which s follows.
MeasuredStatistics ofSummary(const MeasuredSummary& summary) {
    MeasuredStatistics found;
    found.quantity = summary.quantity;
    found.place = placeOf(summary.quantity, summary.place);
    found.count = summary.count;
    found.mean = summary.mean_um;
    found.deviation = summary.deviation_um;
    found.least = summary.least_um;
    found.greatest = summary.greatest_um;
    found.isSummary = true;
    if (!found.deviation && summary.half_width_um && summary.count >= 2) {
        const auto n = static_cast<double>(summary.count);
        found.deviation = *summary.half_width_um * std::sqrt(n)
                          / studentQuantile((1 + summary.confidence) / 2, n - 1);
    }
    return found;
}

} // namespace

std::vector<MeasuredStatistics> statisticsOfMeasured(const Project& project) {
    std::vector<MeasuredStatistics> found;
    if (!project.measured) {
        return found;
    }
    const Measured& measured = *project.measured;
    const int places = placeCount(project);
    std::map<Key, std::vector<double>> values;
    for (const MeasuredPart& part : measured.parts) {
        if (part.place >= places) {
            continue;
        }
        const auto add = [&](MeasuredQuantity quantity, std::optional<double> value) {
            if (value) {
                values[{quantity, placeOf(quantity, part.place)}].push_back(*value);
            }
        };
        if (!part.diameters_mm.empty()) {
            add(MeasuredQuantity::diameter_deviation,
                (meanOf(part.diameters_mm) - project.part->diameter_mm) * units::umPerMm);
        }
        add(MeasuredQuantity::radial_runout, part.radial_runout_um);
        add(MeasuredQuantity::roundness, part.roundness_um);
        add(MeasuredQuantity::cylindricity, part.cylindricity_um);
        add(MeasuredQuantity::roughness_ra, part.roughness_ra_um);
    }
    for (auto& [key, list] : values) {
        found.push_back(ofValues(key, std::move(list)));
    }
    for (const MeasuredSummary& summary : measured.summaries) {
        if (summary.place < places) {
            found.push_back(ofSummary(summary));
        }
    }
    return found;
}

} // namespace sparkout
