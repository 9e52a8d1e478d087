// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/feed_series.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/stage_control.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Sums up the passes of one zone or section in the order of time into the points of its column.
class FeedColumnBuilder {
public:
    /// `group` successive strokes become one point.
    FeedColumnBuilder(const FeedSeries& series, FeedColumn& column, std::size_t radii,
                      std::size_t group);
    void add(std::size_t index, const Pass& pass, const Visit* visits);
    int finish(); ///< closes the last stroke and returns the number of visits that were not finite

private:
    void openStroke(const Pass& pass, const Visit* visits);
    void closeStroke();
    void keepStroke();

    const FeedSeries& m_series;
    FeedColumn& m_column;
    std::size_t m_radii;
    std::size_t m_group;
    std::size_t m_strokes = 0; ///< number of strokes closed so far
    int m_dropped = 0;
    std::vector<double> m_fed_mm;        ///< t_П at the last visit of each radius
    std::vector<double> m_strokeFed_mm;  ///< t_П when the stroke began
    std::vector<double> m_strokeCut_mm;  ///< Σa within the stroke
    std::vector<double> m_strokeCame_mm; ///< radius when the stroke began
    const Visit* m_last = nullptr;       ///< visits of the stroke's latest pass
    FeedPoint m_stroke;
    bool m_open = false;
};

/// Returns a pass as a point; `before` are the visits of the column's previous pass, or null.
[[nodiscard]] FeedPoint passPoint(const FeedSeries& series, const Pass& pass, const Visit* visits,
                                  const Visit* before, std::size_t radii);

/// Returns one visit as a point; `before_mm` is t_П at the radius' previous visit.
[[nodiscard]] FeedPoint radiusPoint(const FeedSeries& series, const Pass& pass, const Visit& visit,
                                    double before_mm, std::size_t k, std::size_t radii);

/// Collects a spread, without values that are not finite.
class SpreadSum {
public:
    void add(double value) {
        if (!std::isfinite(value)) {
            return;
        }
        m_min = std::min(m_min, value);
        m_max = std::max(m_max, value);
        m_sum += value;
        ++m_count;
    }
    [[nodiscard]] Spread spread(double factor = 1) const {
        if (m_count == 0) {
            return {};
        }
        const double mean = std::clamp(m_sum / m_count, m_min, m_max);
        return {m_min * factor, mean * factor, m_max * factor};
    }

private:
    double m_min = std::numeric_limits<double>::max();
    double m_max = std::numeric_limits<double>::lowest();
    double m_sum = 0;
    int m_count = 0;
};

Spread single(double value) {
    return {value, value, value};
}

bool finite(const Visit& v) {
    // A sum is finite only if every term is.
    return std::isfinite(v.programmed_mm + v.actual_mm + v.accumulated_mm + v.radius_mm
                         + v.normalForce_n);
}

double came_mm(const FeedSeries& series, const Visit& v) {
    return v.radius_mm + series.removalSign * v.actual_mm;
}

/// Reads the sums and radii after a pass.
void readEnd(FeedPoint& point, const FeedSeries& series, const Visit* visits, std::size_t radii) {
    SpreadSum programmedSum, actualSum, left;
    for (std::size_t k = 0; k < radii; ++k) {
        if (finite(visits[k])) {
            programmedSum.add(visits[k].programmed_mm);
            actualSum.add(visits[k].accumulated_mm);
            left.add(visits[k].radius_mm - series.target_mm);
        }
    }
    point.programmedSum_um = programmedSum.spread(units::umPerMm);
    point.actualSum_um = actualSum.spread(units::umPerMm);
    point.left_um = left.spread(units::umPerMm);
}

void mergeSpread(Spread& into, const Spread& next, double weight) {
    into.min = std::min(into.min, next.min);
    into.max = std::max(into.max, next.max);
    into.mean += (next.mean - into.mean) * weight;
}

FeedColumnBuilder::FeedColumnBuilder(const FeedSeries& series, FeedColumn& column,
                                     std::size_t radii, std::size_t group)
    : m_series(series)
    , m_column(column)
    , m_radii(radii)
    , m_group(group)
    , m_fed_mm(radii, series.firstFeed_mm)
    , m_strokeFed_mm(radii, series.firstFeed_mm)
    , m_strokeCut_mm(radii, 0.0)
    , m_strokeCame_mm(radii, 0.0) {}

void FeedColumnBuilder::add(std::size_t index, const Pass& pass, const Visit* visits) {
    if (!m_open || m_stroke.place.cycleCount != pass.place.cycleCount) {
        closeStroke();
        openStroke(pass, visits);
    }
    SpreadSum force;
    for (std::size_t k = 0; k < m_radii; ++k) {
        const Visit& v = visits[k];
        if (!finite(v)) {
            m_dropped += v.isGap() ? 0 : 1;
            continue;
        }
        force.add(v.normalForce_n);
        m_fed_mm[k] = v.programmed_mm;
        m_strokeCut_mm[k] += v.actual_mm;
    }
    m_column.passIndex.push_back(index);
    m_last = visits;
    const Spread ofPass = force.spread();
    Spread& ofStroke = m_stroke.force_n;
    ofStroke.min = std::min(ofStroke.min, ofPass.min);
    ofStroke.mean = std::max(ofStroke.mean, ofPass.mean);
    ofStroke.max = std::max(ofStroke.max, ofPass.max);
    m_stroke.axialFeed_mm_min = std::max(m_stroke.axialFeed_mm_min, pass.axialFeed_mm_min);
}

void FeedColumnBuilder::openStroke(const Pass& pass, const Visit* visits) {
    const int number = std::clamp(pass.place.cycleCount, 1, m_series.strokeCount());
    m_stroke = {};
    m_stroke.place = pass.place;
    m_stroke.place.step = Step::none;
    m_stroke.place.revolution = 0;
    m_stroke.start_s = m_series.strokeStart_s[static_cast<std::size_t>(number - 1)];
    m_stroke.end_s = m_series.strokeEnd_s(number);
    m_stroke.force_n.min = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < m_radii; ++k) {
        m_strokeFed_mm[k] = m_fed_mm[k];
        m_strokeCut_mm[k] = 0;
        m_strokeCame_mm[k] = came_mm(m_series, visits[k]);
    }
    m_open = true;
}

void FeedColumnBuilder::closeStroke() {
    if (!m_open) {
        return;
    }
    SpreadSum programmed, actual, came;
    for (std::size_t k = 0; k < m_radii; ++k) {
        if (m_last[k].isGap()) {
            continue;
        }
        programmed.add(m_fed_mm[k] - m_strokeFed_mm[k]);
        actual.add(m_strokeCut_mm[k]);
        came.add(m_strokeCame_mm[k] - m_series.target_mm);
    }
    m_stroke.programmed_um = programmed.spread(units::umPerMm);
    m_stroke.actual_um = actual.spread(units::umPerMm);
    m_stroke.came_um = came.spread(units::umPerMm);
    readEnd(m_stroke, m_series, m_last, m_radii);
    keepStroke();
    m_open = false;
}

/// Merges a stroke with others: feeds as their mean and extremes, sums and radii as at the ends of
/// the group.
void FeedColumnBuilder::keepStroke() {
    const std::size_t inGroup = m_strokes++ % m_group;
    if (inGroup == 0) {
        m_column.strokes.push_back(m_stroke);
        return;
    }
    FeedPoint& p = m_column.strokes.back();
    const double weight = 1.0 / static_cast<double>(inGroup + 1);
    mergeSpread(p.programmed_um, m_stroke.programmed_um, weight);
    mergeSpread(p.actual_um, m_stroke.actual_um, weight);
    mergeSpread(p.force_n, m_stroke.force_n, weight);
    p.programmedSum_um = m_stroke.programmedSum_um;
    p.actualSum_um = m_stroke.actualSum_um;
    p.left_um = m_stroke.left_um;
    p.end_s = m_stroke.end_s;
}

int FeedColumnBuilder::finish() {
    closeStroke();
    return m_dropped;
}

FeedPoint passPoint(const FeedSeries& series, const Pass& pass, const Visit* visits,
                    const Visit* before, std::size_t radii) {
    FeedPoint p;
    p.place = pass.place;
    p.start_s = pass.start_s;
    p.end_s = pass.start_s + pass.duration_s;
    p.axialFeed_mm_min = pass.axialFeed_mm_min;
    SpreadSum programmed, actual, came, force;
    for (std::size_t k = 0; k < radii; ++k) {
        const Visit& v = visits[k];
        if (finite(v)) {
            programmed.add(v.programmed_mm
                           - (before ? before[k].programmed_mm : series.firstFeed_mm));
            actual.add(v.actual_mm);
            came.add(came_mm(series, v) - series.target_mm);
            force.add(v.normalForce_n);
        }
    }
    p.programmed_um = programmed.spread(units::umPerMm);
    p.actual_um = actual.spread(units::umPerMm);
    p.came_um = came.spread(units::umPerMm);
    p.force_n = force.spread();
    readEnd(p, series, visits, radii);
    return p;
}

FeedPoint radiusPoint(const FeedSeries& series, const Pass& pass, const Visit& visit,
                      double before_mm, std::size_t k, std::size_t radii) {
    FeedPoint p;
    p.place = pass.place;
    p.radius = static_cast<int>(k);
    const double share = pass.duration_s / static_cast<double>(radii);
    p.start_s = pass.start_s + share * static_cast<double>(k);
    p.end_s = p.start_s + share;
    p.axialFeed_mm_min = pass.axialFeed_mm_min;
    p.programmed_um = single((visit.programmed_mm - before_mm) * units::umPerMm);
    p.actual_um = single(visit.actual_mm * units::umPerMm);
    p.programmedSum_um = single(visit.programmed_mm * units::umPerMm);
    p.actualSum_um = single(visit.accumulated_mm * units::umPerMm);
    p.left_um = single((visit.radius_mm - series.target_mm) * units::umPerMm);
    p.came_um = single((came_mm(series, visit) - series.target_mm) * units::umPerMm);
    p.force_n = single(visit.normalForce_n);
    return p;
}

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
