// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/fit_data.h"

#include "core/measured/cycle_response.h"
#include "core/measured/fit_problem.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/project/machine.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace sparkout {

namespace {

/// Greatest number of samples used to align a trace.
constexpr std::size_t mostAligned = 400;

FitData thinned(FitData data) {
    for (FitGroup& group : data.groups) {
        const std::size_t every = (group.values.size() + mostAligned - 1) / mostAligned;
        if (every <= 1) {
            continue;
        }
        std::vector<double> times, values;
        for (std::size_t i = 0; i < group.values.size(); i += every) {
            times.push_back(group.time_s[i]);
            values.push_back(group.values[i]);
        }
        group.time_s = std::move(times);
        group.values = std::move(values);
    }
    return data;
}

/// The parameters of the alignment of traces, which do not change the cycle.
std::vector<FittedParameter> alignment(const FitData& data) {
    std::vector<FittedParameter> list{{FittedKind::time_shift, {}, {}}};
    if (data.has(FitSource::size)) {
        list.push_back({FittedKind::size_offset, {}, {}});
    }
    const bool isStated = std::ranges::any_of(
        data.groups, [](const FitGroup& group) { return group.idle_kw.has_value(); });
    if (data.has(FitSource::power) && !isStated) {
        list.push_back({FittedKind::idle_power, {}, {}});
    }
    return list;
}

/// The traces of each file, in the order of their first ones.
std::vector<std::vector<int>> tracesByFile(const std::vector<MeasuredTrace>& traces) {
    std::vector<std::pair<std::string, std::vector<int>>> files;
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const std::string file = traces[i].source + '/' + traces[i].source_sha256;
        auto known = std::ranges::find_if(files, [&](const auto& f) { return f.first == file; });
        if (known == files.end()) {
            known = files.insert(files.end(), {file, {}});
        }
        known->second.push_back(static_cast<int>(i));
    }
    std::vector<std::vector<int>> lists;
    lists.reserve(files.size());
    for (auto& [file, list] : files) {
        lists.push_back(std::move(list));
    }
    return lists;
}

void compareFile(const Project& project, const FitData& data, const std::vector<int>& stepsByStage,
                 const std::stop_token& stop, std::vector<TraceComparison>& found) {
    const FitData sparse = thinned(data);
    const std::vector<FittedParameter> list = alignment(data);
    FitProblem coarse(project, sparse, list, stop);
    coarse.setSteps(stepsByStage);
    const std::vector<bool> free(list.size(), false);
    const LeastSquares best = minimise(coarse, coarse.start(), free);
    FitProblem whole(project, data, list, stop);
    whole.setSteps(stepsByStage);
    std::vector<double> differences;
    if (stop.stop_requested() || !whole.differences(best.q, differences)) {
        return;
    }
    const double shift_s = FitProblem::valueOf(FittedKind::time_shift, best.q.front());
    std::size_t at = 0;
    for (const FitGroup& group : data.groups) {
        TraceComparison one{group.trace, group.source, group.place, {}, {}, {}, 0, shift_s, 0};
        if (group.source == FitSource::size) {
            one.offset_mm = FitProblem::valueOf(FittedKind::size_offset, best.q[1]);
        }
        double squares = 0;
        for (std::size_t i = 0; i < group.values.size(); ++i, ++at) {
            one.time_s.push_back(group.time_s[i] - shift_s);
            one.measured.push_back(group.values[i] - one.offset_mm);
            one.predicted.push_back(one.measured.back() - differences[at]);
            squares += differences[at] * differences[at];
        }
        one.rms = std::sqrt(squares / static_cast<double>(group.values.size()));
        found.push_back(std::move(one));
    }
}

} // namespace

std::vector<TraceComparison> compareTraces(const Project& project,
                                           const std::vector<int>& stepsByStage,
                                           const std::stop_token& stop) {
    std::vector<TraceComparison> found;
    if (!project.measured) {
        return found;
    }
    for (const std::vector<int>& traces : tracesByFile(project.measured->traces)) {
        const FitData data = fitDataOf(project, traces, false);
        if (!data.groups.empty() && !stop.stop_requested()) {
            compareFile(project, data, stepsByStage, stop, found);
        }
    }
    std::ranges::sort(found, {}, &TraceComparison::trace);
    return found;
}

namespace {

/// What a parameter belongs to.
enum class ParameterRole {
    depthFactor, ///< a factor of an input on which the depths of cut depend
    powerFactor, ///< a factor of an input that acts on the power alone
    input,       ///< an input by its value
    trace,       ///< of the traces
    recorder     ///< of the traces, as their recorder leaves them
};

/// A row of the table of parameters. The reasons of the usual ranges stand in MODEL-13.
struct ParameterRow {
    FittedKind kind;
    const char* key;
    const char* unit;
    ParameterRole role;
    double plausible; ///< distance beyond which it counts as unknown
    Interval usual;   ///< its value; of the setting of the gauge the difference from the project's
};

constexpr Interval within(double factor) {
    return {1 / factor, factor};
}

/// Of the traces' clock and zero, which are set anywhere: a size may be recorded as a diameter.
constexpr Interval anywhere{-std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};

constexpr ParameterRow parameterRows[] = {
    {FittedKind::alpha, "alpha", "", ParameterRole::depthFactor, 2, within(20)},
    {FittedKind::beta, "beta", "", ParameterRole::depthFactor, 2, within(20)},
    {FittedKind::compliance, "compliance", "", ParameterRole::depthFactor, 2, within(10)},
    {FittedKind::flow_stress, "flow_stress", "", ParameterRole::depthFactor, 2, within(4)},
    {FittedKind::dullness, "dullness", "", ParameterRole::depthFactor, 2, within(10)},
    {FittedKind::chip_power, "chip_power", "", ParameterRole::powerFactor, 2, within(4)},
    {FittedKind::friction_power, "friction_power", "", ParameterRole::powerFactor, 2, within(20)},
    {FittedKind::idle_power, "idle_power", "kW", ParameterRole::trace, 1, {-1, 25}},
    {FittedKind::size_offset, "size_offset", "mm", ParameterRole::recorder, 0.1, anywhere},
    {FittedKind::time_shift, "time_shift", "s", ParameterRole::recorder, 1, anywhere},
    {FittedKind::power_delay, "power_delay", "s", ParameterRole::recorder, 1, {-2, 2}},
    {FittedKind::force_delay, "force_delay", "s", ParameterRole::recorder, 1, {-2, 2}},
    {FittedKind::blank_runout, "blank_runout", "mm", ParameterRole::input, 2, {0, 0.5}},
    {FittedKind::gauge_lag, "gauge_lag", "s", ParameterRole::recorder, 1, {-0.2, 2}},
    {FittedKind::power_lag, "power_lag", "s", ParameterRole::recorder, 1, {-0.2, 3}},
    {FittedKind::force_lag, "force_lag", "s", ParameterRole::recorder, 1, {-0.2, 2}},
    {FittedKind::gauge_drift, "gauge_drift", "mm/min", ParameterRole::recorder, 0.1, {-0.1, 0.1}},
    {FittedKind::gauge_setting, "gauge_setting", "mm", ParameterRole::input, 0.1, {-0.1, 0.1}},
};

static_assert(std::size(parameterRows) == static_cast<std::size_t>(FittedKind::count_)
                  && std::ranges::is_sorted(parameterRows, std::less_equal{}, &ParameterRow::kind),
              "one row for each parameter, in the order of the kinds");

const ParameterRow& parameterRow(FittedKind kind) {
    return parameterRows[static_cast<std::size_t>(kind)];
}

} // namespace

bool isFactor(FittedKind kind) {
    return actsOnDepths(kind) || parameterRow(kind).role == ParameterRole::powerFactor;
}

bool actsOnDepths(FittedKind kind) {
    return parameterRow(kind).role == ParameterRole::depthFactor;
}

bool isOfRecorder(FittedKind kind) {
    return parameterRow(kind).role == ParameterRole::recorder;
}

bool isLag(FittedKind kind) {
    return kind == FittedKind::gauge_lag || kind == FittedKind::power_lag
           || kind == FittedKind::force_lag;
}

bool isInput(FittedKind kind) {
    return isFactor(kind) || parameterRow(kind).role == ParameterRole::input;
}

double plausibleRange(FittedKind kind) {
    return parameterRow(kind).plausible;
}

const char* keyOf(FittedKind kind) {
    return parameterRow(kind).key;
}

const char* unitOf(FittedKind kind) {
    return parameterRow(kind).unit;
}

std::optional<Interval> usualRange(const Project& project, FittedKind kind, bool hasTraces) {
    Interval usual = parameterRow(kind).usual;
    if (!std::isfinite(usual.low)) {
        return std::nullopt;
    }
    if (kind == FittedKind::gauge_setting) {
        const double setting_mm = 2 * targetRadius(*project.part);
        usual = {setting_mm + usual.low, setting_mm + usual.high};
    }
    if (hasTraces && actsOnDepths(kind)) {
        const Interval searched = within(mostSearchedFactor);
        usual = {std::max(usual.low, searched.low), std::min(usual.high, searched.high)};
    }
    return usual;
}

bool areApplicable(const Project& project, const std::vector<FittedParameter>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        const bool twice =
            std::any_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const FittedParameter& other) {
                            return other.kind == list[i].kind && other.place == list[i].place;
                        });
        const bool noPlace =
            list[i].place.has_value()
            && (list[i].kind != FittedKind::compliance || !hasPlaceCompliances(project)
                || *list[i].place < 0 || *list[i].place >= placeCount(project));
        const bool measuredForm = list[i].kind == FittedKind::blank_runout
                                  && project.part->profile == ProfileForm::measured;
        const bool threshold = hasThreshold(project);
        const bool notLinear =
            (list[i].kind == FittedKind::alpha || list[i].kind == FittedKind::beta)
            && project.machine->wheel_contact && !threshold;
        const bool notInForce =
            threshold
            && (list[i].kind == FittedKind::flow_stress || list[i].kind == FittedKind::dullness);
        if (twice || noPlace || measuredForm || notLinear || notInForce) {
            return false;
        }
    }
    return true;
}

namespace {

constexpr std::size_t leastForNoise = 5; ///< values

/// The least difference of two unequal values; 0 if all are equal.
double stepOf(std::vector<double> values) {
    std::ranges::sort(values);
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double difference = values[i] - values[i - 1];
        step = difference > 0 ? std::min(step, difference) : step;
    }
    return std::isfinite(step) ? step : 0;
}

/// The weight of a trace, never so small that rounding would matter.
double weightOf(const FitGroup& group) {
    constexpr double leastShare = 1e-6, leastSpan = 1e-9;
    const auto [low, high] = std::ranges::minmax(group.values);
    return std::max(std::max(high - low, leastSpan) * leastShare,
                    noiseOfTrace(group.time_s, group.values).value_or(0));
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
    group.noise = weightOf(group);
    group.step = stepOf(group.values);
    group.measured = static_cast<std::int64_t>(group.values.size());
    return group;
}

/// The mean sizes that are summed up.
FitGroup summariesOf(const Project& project) {
    FitGroup group;
    group.source = FitSource::parts;
    for (const MeasuredSummary& summary : project.measured->summaries) {
        if (summary.quantity == MeasuredQuantity::diameter_deviation
            && summary.place < placeCount(project)) {
            group.places.push_back(summary.place);
            group.values.push_back(summary.mean_um);
            group.measured += summary.count;
        }
    }
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
    group.measured = static_cast<std::int64_t>(group.values.size());
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

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<double> noiseOfTrace(const std::vector<double>& time_s,
                                   const std::vector<double>& values) {
    if (values.size() < leastForNoise || time_s.size() != values.size()) {
        return std::nullopt;
    }
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const double between_s = time_s[i + 1] - time_s[i - 1];
        if (between_s > 0) {
            // The difference has the variance σ²·(1 + before² + after²).
            const double before = (time_s[i + 1] - time_s[i]) / between_s, after = 1 - before;
            const double difference = values[i] - before * values[i - 1] - after * values[i + 1];
            sum += difference * difference / (1 + before * before + after * after);
            ++count;
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    constexpr double twelve = 12; // rounding to a step has the variance step²/12
    return std::max(std::sqrt(sum / static_cast<double>(count)),
                    stepOf(values) / std::sqrt(twelve));
}

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
        if (parts.values.empty() && data.groups.empty()) {
            parts = summariesOf(project);
        }
        if (!parts.values.empty()) {
            data.groups.push_back(std::move(parts));
        }
    }
    return data;
}

std::vector<FittedKind> proposedParameters(const FitData& data, bool hasThreshold) {
    const bool size = data.has(FitSource::size), power = data.has(FitSource::power);
    const bool force = data.has(FitSource::force), parts = data.has(FitSource::parts);
    std::vector<FittedKind> kinds;
    if (force && (size || parts)) {
        kinds = {FittedKind::compliance, FittedKind::flow_stress, FittedKind::dullness};
    } else if (force) {
        kinds = {FittedKind::flow_stress, FittedKind::dullness};
    } else if (size) {
        kinds = {FittedKind::alpha, FittedKind::beta};
    } else if (parts) {
        // Sizes in one place determine either the gauge's setting or the compliance, not both.
        kinds = {power ? FittedKind::compliance : FittedKind::gauge_setting};
        std::set<int> places;
        for (const FitGroup& group : data.groups) {
            places.insert(group.places.begin(), group.places.end());
        }
        if (places.size() > 1 && !power) {
            kinds.insert(kinds.begin(), FittedKind::beta);
        }
    }
    if (hasThreshold) {
        std::ranges::replace(kinds, FittedKind::flow_stress, FittedKind::alpha);
        std::ranges::replace(kinds, FittedKind::dullness, FittedKind::beta);
    }
    if (power) {
        kinds.insert(kinds.end(), {FittedKind::chip_power, FittedKind::friction_power});
        const bool isStated = std::ranges::any_of(
            data.groups, [](const FitGroup& group) { return group.idle_kw.has_value(); });
        if (!isStated) {
            kinds.push_back(FittedKind::idle_power);
        }
    }
    if (size) {
        kinds.push_back(FittedKind::size_offset);
    }
    if (size || power || force) {
        kinds.push_back(FittedKind::time_shift);
    }
    return kinds;
}

} // namespace sparkout
