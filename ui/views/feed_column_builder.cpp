// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feed_column_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr double um_per_mm = 1000;

/// Collects a spread; a value that is not finite is left out.
class SpreadSum {
public:
    void add(double value) {
        if (!std::isfinite(value)) {
            return;
        }
        m_min = m_count == 0 ? value : std::min(m_min, value);
        m_max = m_count == 0 ? value : std::max(m_max, value);
        m_sum += value;
        ++m_count;
    }
    [[nodiscard]] Spread spread(double factor = 1) const {
        const double mean = m_count == 0 ? 0 : m_sum / m_count;
        return {m_min * factor, std::clamp(mean, m_min, m_max) * factor, m_max * factor};
    }

private:
    double m_min = 0, m_max = 0, m_sum = 0;
    int m_count = 0;
};

Spread single(double value) {
    return {value, value, value};
}

bool finite(const Visit& v) {
    return std::isfinite(v.programmed_mm) && std::isfinite(v.actual_mm)
           && std::isfinite(v.accumulated_mm) && std::isfinite(v.radius_mm)
           && std::isfinite(v.normalForce_n);
}

} // namespace

FeedColumnBuilder::FeedColumnBuilder(const FeedSeries& series, FeedColumn& column,
                                     std::size_t radii)
    : m_series(series)
    , m_column(column)
    , m_radii(radii)
    , m_fed_mm(radii, 0.0)
    , m_strokeFed_mm(radii, 0.0)
    , m_strokeCut_mm(radii, 0.0)
    , m_strokeCame_mm(radii, 0.0) {}

void FeedColumnBuilder::add(std::size_t index, const Pass& pass, const Visit* visits) {
    if (!m_open || m_stroke.place.cycleCount != pass.place.cycleCount) {
        closeStroke();
        openStroke(pass, visits);
    }
    SpreadSum programmed, actual, programmedSum, actualSum, came, left, force;
    for (std::size_t k = 0; k < m_radii; ++k) {
        const Visit& v = visits[k];
        if (!finite(v)) {
            ++m_dropped;
            continue;
        }
        programmed.add(v.programmed_mm - m_fed_mm[k]);
        actual.add(v.actual_mm);
        programmedSum.add(v.programmed_mm);
        actualSum.add(v.accumulated_mm);
        left.add(v.radius_mm - m_series.target_mm);
        came.add(v.radius_mm + m_series.removalSign * v.actual_mm - m_series.target_mm);
        force.add(v.normalForce_n);
        m_fed_mm[k] = v.programmed_mm;
        m_strokeCut_mm[k] += v.actual_mm;
    }
    FeedPoint p;
    p.place = pass.place;
    p.start_s = pass.start_s;
    p.end_s = pass.start_s + pass.duration_s;
    p.axialFeed_mm_min = pass.axialFeed_mm_min;
    p.programmed_um = programmed.spread(um_per_mm);
    p.actual_um = actual.spread(um_per_mm);
    p.programmedSum_um = programmedSum.spread(um_per_mm);
    p.actualSum_um = actualSum.spread(um_per_mm);
    p.came_um = came.spread(um_per_mm);
    p.left_um = left.spread(um_per_mm);
    p.force_n = force.spread();
    m_column.passIndex.push_back(index);
    m_column.passes.push_back(p);
    growStroke(p);
}

void FeedColumnBuilder::growStroke(const FeedPoint& p) {
    m_stroke.axialFeed_mm_min = std::max(m_stroke.axialFeed_mm_min, p.axialFeed_mm_min);
    m_stroke.programmedSum_um = p.programmedSum_um;
    m_stroke.actualSum_um = p.actualSum_um;
    m_stroke.left_um = p.left_um;
    m_stroke.force_n.min = std::min(m_stroke.force_n.min, p.force_n.min);
    m_stroke.force_n.max = std::max(m_stroke.force_n.max, p.force_n.max);
    m_stroke.force_n.mean = std::max(m_stroke.force_n.mean, p.force_n.mean);
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
        m_strokeCame_mm[k] = visits[k].radius_mm + m_series.removalSign * visits[k].actual_mm;
    }
    m_open = true;
}

void FeedColumnBuilder::closeStroke() {
    if (!m_open) {
        return;
    }
    SpreadSum programmed, actual, came;
    for (std::size_t k = 0; k < m_radii; ++k) {
        programmed.add(m_fed_mm[k] - m_strokeFed_mm[k]);
        actual.add(m_strokeCut_mm[k]);
        came.add(m_strokeCame_mm[k] - m_series.target_mm);
    }
    m_stroke.programmed_um = programmed.spread(um_per_mm);
    m_stroke.actual_um = actual.spread(um_per_mm);
    m_stroke.came_um = came.spread(um_per_mm);
    m_column.strokes.push_back(m_stroke);
    m_open = false;
}

int FeedColumnBuilder::finish() {
    closeStroke();
    return m_dropped;
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
    p.programmed_um = single((visit.programmed_mm - before_mm) * um_per_mm);
    p.actual_um = single(visit.actual_mm * um_per_mm);
    p.programmedSum_um = single(visit.programmed_mm * um_per_mm);
    p.actualSum_um = single(visit.accumulated_mm * um_per_mm);
    const double left = visit.radius_mm - series.target_mm;
    p.left_um = single(left * um_per_mm);
    p.came_um = single((left + series.removalSign * visit.actual_mm) * um_per_mm);
    p.force_n = single(visit.normalForce_n);
    return p;
}

} // namespace sparkout
