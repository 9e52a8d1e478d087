// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/feed_series.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/feed_column_builder.h"
#include "core/simulation/stage_control.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

std::vector<FeedColumn> emptyColumns(const SimulationResult& result) {
    std::vector<FeedColumn> columns;
    const bool sections = !result.project.operation->travels;
    const int gauge = sections ? gaugeSection(result.project) : -1;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const int section = sections ? static_cast<int>(i) : 0;
        columns.push_back({result.sections[i].zone, section, sections && section == gauge, {}, {}});
    }
    return columns;
}

/// Reads the starts of strokes and stages, and the end of the last pass.
void readTimes(FeedSeries& series, const Trajectory& trajectory) {
    for (const Pass& pass : trajectory.passes) {
        const auto number = static_cast<std::size_t>(std::max(pass.place.cycleCount, 1));
        if (number > series.strokeStart_s.size()) {
            series.strokeStart_s.resize(number, pass.start_s);
        }
        if (series.stages.empty() || series.stages.back().stage != pass.place.stage) {
            if (!series.stages.empty()) {
                series.stages.back().end_s = pass.start_s;
            }
            series.stages.push_back({pass.place.stage, pass.start_s, pass.start_s});
        }
        series.end_s = std::max(series.end_s, pass.start_s + pass.duration_s);
    }
    if (!series.stages.empty()) {
        series.stages.back().end_s = series.end_s;
    }
}

/// The index of the column of a pass.
std::size_t columnOf(const Place& place) {
    switch (place.zone) {
    case Zone::rz1: return 0;
    case Zone::nz: return 1;
    case Zone::rz2: return 2;
    case Zone::section: break;
    }
    return static_cast<std::size_t>(place.section);
}

/// First and past-last index, into column.passIndex, of the passes that touch the time span.
std::pair<std::size_t, std::size_t> touching(const FeedColumn& column, const Trajectory& trajectory,
                                             double from_s, double to_s) {
    const auto begin = column.passIndex.begin(), end = column.passIndex.end();
    const auto first = std::partition_point(begin, end, [&](std::size_t i) {
        const Pass& pass = trajectory.passes[i];
        return pass.start_s + pass.duration_s < from_s;
    });
    const auto last = std::partition_point(
        first, end, [&](std::size_t i) { return trajectory.passes[i].start_s <= to_s; });
    return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin)};
}

std::pair<std::size_t, std::size_t>
withNeighbours(const FeedColumn& column, const Trajectory& trajectory, double from_s, double to_s) {
    const auto [first, last] = touching(column, trajectory, from_s, to_s);
    return {first > 0 ? first - 1 : 0, std::min(last + 1, column.passIndex.size())};
}

const Visit* visitsBefore(const FeedColumn& column, const Trajectory& trajectory, std::size_t i) {
    return i == 0
               ? nullptr
               : trajectory.visits.data() + trajectory.passes[column.passIndex[i - 1]].firstVisit;
}

std::size_t radiiOf(const Trajectory& trajectory) {
    return static_cast<std::size_t>(std::max(trajectory.radii, 0));
}

} // namespace

double FeedSeries::strokeEnd_s(int number) const {
    return number < strokeCount() ? strokeStart_s[static_cast<std::size_t>(number)] : end_s;
}

int FeedSeries::strokeAt(double time_s) const {
    const auto it = std::upper_bound(strokeStart_s.begin(), strokeStart_s.end(), time_s);
    return std::clamp(static_cast<int>(it - strokeStart_s.begin()), 1, std::max(strokeCount(), 1));
}

FeedSeries makeFeedSeries(const SimulationResult& result, const Trajectory& trajectory) {
    FeedSeries series;
    series.operation = result.project.operation;
    series.target_mm = targetRadius(*result.project.part);
    series.firstFeed_mm = firstFeed(result.project, makeBlank(*result.project.part).totalInfeed_mm);
    series.removalSign = result.project.part->surface == Surface::internal ? -1 : 1;
    series.revolutions_per_s = result.project.machine->work_speed_rpm / units::secondsPerMinute;
    series.columns = emptyColumns(result);
    readTimes(series, trajectory);
    const std::size_t group =
        (series.strokeStart_s.size() + mostStrokePoints - 1) / mostStrokePoints;
    std::vector<FeedColumnBuilder> builders;
    builders.reserve(series.columns.size());
    for (FeedColumn& column : series.columns) {
        builders.emplace_back(series, column, radiiOf(trajectory), std::max(group, std::size_t{1}));
    }
    for (std::size_t i = 0; i < trajectory.passes.size(); ++i) {
        const Pass& pass = trajectory.passes[i];
        const std::size_t column = columnOf(pass.place);
        if (column < builders.size()) {
            builders[column].add(i, pass, trajectory.visits.data() + pass.firstVisit);
        }
    }
    for (FeedColumnBuilder& builder : builders) {
        series.dropped += builder.finish();
    }
    return series;
}

std::vector<int> shownSections(int count, int gauge, std::optional<int> wanted, int most) {
    std::vector<int> shown;
    const int n = std::min(count, most);
    shown.reserve(static_cast<std::size_t>(std::max(n, 0)));
    for (int i = 0; i < n; ++i) {
        shown.push_back(n == 1 ? gauge : (i * (count - 1) + (n - 1) / 2) / (n - 1));
    }
    // Puts a section in place of the nearest one that may be replaced.
    const auto insert = [&](int section, std::optional<int> keep) {
        if (section < 0 || section >= count || std::ranges::count(shown, section) > 0) {
            return;
        }
        int* nearest = nullptr;
        for (int& s : shown) {
            const bool end = !keep && n > 2 && (s == 0 || s == count - 1);
            if (!end && s != keep
                && (!nearest || std::abs(s - section) < std::abs(*nearest - section))) {
                nearest = &s;
            }
        }
        if (nearest) {
            *nearest = section;
        }
    };
    insert(gauge, {});
    if (wanted) {
        insert(*wanted, gauge);
    }
    std::ranges::sort(shown);
    return shown;
}

FeedPoints passPoints(const FeedSeries& series, const FeedColumn& column,
                      const Trajectory& trajectory, double from_s, double to_s) {
    const auto [first, last] = withNeighbours(column, trajectory, from_s, to_s);
    FeedPoints points;
    points.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
        const Pass& pass = trajectory.passes[column.passIndex[i]];
        points.push_back(passPoint(series, pass, trajectory.visits.data() + pass.firstVisit,
                                   visitsBefore(column, trajectory, i), radiiOf(trajectory)));
    }
    return points;
}

std::vector<StepSpan> stepSpans(const FeedColumn& column, const Trajectory& trajectory,
                                double from_s, double to_s) {
    const auto [first, last] = withNeighbours(column, trajectory, from_s, to_s);
    std::vector<StepSpan> spans;
    for (std::size_t i = first; i < last; ++i) {
        const Pass& pass = trajectory.passes[column.passIndex[i]];
        const double end_s = pass.start_s + pass.duration_s;
        if (!spans.empty() && spans.back().place.step == pass.place.step
            && spans.back().place.cycleCount == pass.place.cycleCount) {
            spans.back().end_s = end_s;
        } else {
            spans.push_back({pass.place, pass.start_s, end_s});
        }
    }
    return spans;
}

FeedPoints radiusPoints(const FeedSeries& series, const FeedColumn& column,
                        const Trajectory& trajectory, double from_s, double to_s) {
    const std::size_t K = radiiOf(trajectory);
    const auto [first, last] = touching(column, trajectory, from_s, to_s);
    FeedPoints points;
    points.reserve((last - first) * K);
    for (std::size_t i = first; i < last; ++i) {
        const Pass& pass = trajectory.passes[column.passIndex[i]];
        const Visit* before = visitsBefore(column, trajectory, i);
        const Visit* visits = trajectory.visits.data() + pass.firstVisit;
        for (std::size_t k = 0; k < K; ++k) {
            const double fed_mm = before ? before[k].programmed_mm : series.firstFeed_mm;
            points.push_back(radiusPoint(series, pass, visits[k], fed_mm, k, K));
        }
    }
    return points;
}

} // namespace sparkout
