// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit_data.h"

#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/statistics/median.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

double spanOf(const std::vector<double>& values) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return *greatest - *least;
}

/// From second differences, whose variance is 6σ² where the curve is nearly straight; never so
/// small that rounding would count.
double noiseOf(const std::vector<double>& values) {
    constexpr double leastShare = 1e-6, secondDifference = 2.449489742783178; // √6
    const double least = std::max(spanOf(values), 1e-9) * leastShare;
    if (values.size() < 5) {
        return least;
    }
    std::vector<double> differences;
    for (std::size_t i = 2; i < values.size(); ++i) {
        differences.push_back(std::abs(values[i] - 2 * values[i - 1] + values[i - 2]));
    }
    return std::max(least,
                    deviationPerMedian * medianOf(std::move(differences)) / secondDifference);
}

FitSource sourceOf(TraceQuantity quantity) {
    switch (quantity) {
    case TraceQuantity::wheel_power:
    case TraceQuantity::spindle_current: return FitSource::power;
    case TraceQuantity::normal_force: return FitSource::force;
    case TraceQuantity::gauge_size: break;
    }
    return FitSource::size;
}

FitGroup groupOf(const MeasuredTrace& trace, int number) {
    const double factor =
        trace.quantity == TraceQuantity::spindle_current ? trace.factor_kw_per_a.value_or(1) : 1;
    FitGroup group;
    group.source = sourceOf(trace.quantity);
    group.trace = number;
    group.place = trace.place;
    group.time_s = trace.time_s.values();
    for (const double value : trace.values.values()) {
        group.values.push_back(value * factor);
    }
    if (trace.idle) {
        group.idle_kw = *trace.idle * factor;
    }
    group.noise = noiseOf(group.values);
    return group;
}

FitGroup partsOf(const Project& project) {
    FitGroup group;
    group.source = FitSource::parts;
    for (const MeasuredPart& part : project.measured->parts) {
        if (!part.diameters_mm.empty() && part.place < placeCount(project)) {
            const double mean_mm =
                std::accumulate(part.diameters_mm.begin(), part.diameters_mm.end(), 0.0)
                / static_cast<double>(part.diameters_mm.size());
            group.places.push_back(part.place);
            group.values.push_back((mean_mm - project.part->diameter_mm) * units::umPerMm);
        }
    }
    if (!group.values.empty()) {
        std::vector<double> from = group.values;
        const double middle = medianOf(from);
        for (double& value : from) {
            value = std::abs(value - middle);
        }
        constexpr double least_um = 0.1;
        group.noise = std::max(least_um, deviationPerMedian * medianOf(std::move(from)));
    }
    return group;
}

} // namespace

bool FitData::has(FitSource source) const {
    return std::ranges::any_of(groups,
                               [source](const FitGroup& group) { return group.source == source; });
}

std::size_t FitData::count() const {
    std::size_t sum = 0;
    for (const FitGroup& group : groups) {
        sum += group.values.size();
    }
    return sum;
}

FitData fitDataOf(const Project& project, const std::vector<int>& traces, bool withParts) {
    FitData data;
    if (!project.measured) {
        return data;
    }
    const Measured& measured = *project.measured;
    for (std::size_t i = 0; i < measured.traces.size(); ++i) {
        const MeasuredTrace& trace = measured.traces[i];
        const int number = static_cast<int>(i);
        const bool wanted = traces.empty() || std::ranges::find(traces, number) != traces.end();
        if (!wanted || trace.values.empty() || trace.values.size() != trace.time_s.size()
            || (trace.place && *trace.place >= placeCount(project))) {
            continue;
        }
        if (trace.quantity == TraceQuantity::spindle_current && !trace.factor_kw_per_a) {
            data.withoutFactor.push_back(number);
        } else {
            data.groups.push_back(groupOf(trace, number));
        }
    }
    if (withParts) {
        FitGroup parts = partsOf(project);
        if (!parts.values.empty()) {
            data.groups.push_back(std::move(parts));
        }
    }
    return data;
}

} // namespace sparkout
