// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feed_series.h"

#include "core/process/profile.h"
#include "ui/views/feed_column_builder.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

std::vector<FeedColumn> emptyColumns(const SimulationResult& result,
                                     const std::vector<int>& sections) {
    std::vector<FeedColumn> columns;
    if (result.project.operation == Operation::traverse) {
        for (Zone zone : {Zone::rz1, Zone::nz, Zone::rz2}) {
            columns.push_back({zone, 0, false, {}, {}, {}});
        }
    } else {
        for (int section : sections) {
            columns.push_back(
                {Zone::section, section, section == gaugeSection(result), {}, {}, {}});
        }
    }
    return columns;
}

/// Starts of strokes and stages, and the end of the last pass.
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

bool belongs(const Place& place, const FeedColumn& column) {
    return place.zone == column.zone
           && (column.zone != Zone::section || place.section == column.section);
}

void mergeSpread(Spread& into, const Spread& next, double weight) {
    into.min = std::min(into.min, next.min);
    into.max = std::max(into.max, next.max);
    into.mean += (next.mean - into.mean) * weight;
}

/// Points joined in groups, so that no more than the limit are left: feeds as their mean and
/// extremes, sums and radii as they stand at the group's ends.
FeedPoints thinned(FeedPoints points, std::size_t limit) {
    if (points.size() <= limit) {
        return points;
    }
    const std::size_t group = (points.size() + limit - 1) / limit;
    FeedPoints out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % group == 0) {
            out.push_back(points[i]);
            continue;
        }
        FeedPoint& p = out.back();
        const FeedPoint& next = points[i];
        const double weight = 1.0 / static_cast<double>(i % group + 1);
        mergeSpread(p.programmed_um, next.programmed_um, weight);
        mergeSpread(p.actual_um, next.actual_um, weight);
        mergeSpread(p.force_n, next.force_n, weight);
        p.programmedSum_um = next.programmedSum_um;
        p.actualSum_um = next.actualSum_um;
        p.left_um = next.left_um;
        p.end_s = next.end_s;
    }
    return out;
}

} // namespace

double FeedSeries::strokeEnd_s(int number) const {
    return number < strokeCount() ? strokeStart_s[static_cast<std::size_t>(number)] : end_s;
}

int FeedSeries::strokeAt(double time_s) const {
    const auto it = std::upper_bound(strokeStart_s.begin(), strokeStart_s.end(), time_s);
    return std::clamp(static_cast<int>(it - strokeStart_s.begin()), 1, std::max(strokeCount(), 1));
}

int gaugeSection(const SimulationResult& result) {
    const int count = static_cast<int>(result.sections.size());
    const Gauge& gauge = result.project.gauge;
    if (count == 0) {
        return 0;
    }
    if (gauge.position_mm) {
        const auto nearer = [&](const SectionResult& a, const SectionResult& b) {
            return std::abs(a.position_mm - *gauge.position_mm)
                   < std::abs(b.position_mm - *gauge.position_mm);
        };
        return static_cast<int>(
            std::min_element(result.sections.begin(), result.sections.end(), nearer)
            - result.sections.begin());
    }
    return std::clamp(gauge.section.value_or(count / 2), 0, count - 1);
}

std::vector<int> shownSections(int count, int gauge, std::optional<int> wanted, int most) {
    std::vector<int> shown;
    const int n = std::min(count, most);
    for (int i = 0; i < n; ++i) {
        shown.push_back(n == 1 ? gauge : (i * (count - 1) + (n - 1) / 2) / (n - 1));
    }
    // Put a section in place of the nearest one that may go.
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

FeedSeries makeFeedSeries(const SimulationResult& result, const Trajectory& trajectory,
                          const std::vector<int>& sections) {
    FeedSeries series;
    series.operation = result.project.operation;
    series.target_mm = targetRadius(result.project.part);
    series.removalSign = result.project.part.surface == Surface::internal ? -1 : 1;
    series.revolutions_per_s = result.project.machine.work_speed_rpm / 60;
    series.columns = emptyColumns(result, sections);
    readTimes(series, trajectory);
    const auto K = static_cast<std::size_t>(std::max(trajectory.radii, 0));
    for (FeedColumn& column : series.columns) {
        FeedColumnBuilder builder(series, column, K);
        for (std::size_t i = 0; i < trajectory.passes.size(); ++i) {
            const Pass& pass = trajectory.passes[i];
            if (belongs(pass.place, column)) {
                builder.add(i, pass, trajectory.visits.data() + pass.firstVisit);
            }
        }
        series.dropped += builder.finish();
        column.strokes = thinned(std::move(column.strokes), mostStrokePoints);
    }
    return series;
}

FeedPoints radiusPoints(const FeedSeries& series, const FeedColumn& column,
                        const Trajectory& trajectory, double from_s, double to_s) {
    FeedPoints points;
    const auto K = static_cast<std::size_t>(std::max(trajectory.radii, 0));
    for (std::size_t i = 0; i < column.passIndex.size(); ++i) {
        const Pass& pass = trajectory.passes[column.passIndex[i]];
        if (pass.start_s + pass.duration_s < from_s || pass.start_s > to_s) {
            continue;
        }
        const Visit* before = i == 0 ? nullptr
                                     : trajectory.visits.data()
                                           + trajectory.passes[column.passIndex[i - 1]].firstVisit;
        const Visit* visits = trajectory.visits.data() + pass.firstVisit;
        for (std::size_t k = 0; k < K; ++k) {
            points.push_back(
                radiusPoint(series, pass, visits[k], before ? before[k].programmed_mm : 0, k, K));
        }
    }
    return points;
}

} // namespace sparkout
