// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/feed_column_builder.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

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

} // namespace

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

} // namespace sparkout
