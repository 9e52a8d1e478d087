// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/trace_comparison.h"

#include "core/identification/fit_problem.h"
#include "core/identification/levenberg_marquardt.h"
#include "core/project/measured.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

} // namespace sparkout
