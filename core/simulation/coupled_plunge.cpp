// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/coupled_plunge.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

std::vector<double> positionsOf(const std::vector<CompliantPoint>& points, std::size_t count) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back(points[i].position_mm);
    }
    return positions;
}

std::vector<double> gaugeInfluence(const Project& project,
                                   const std::vector<CompliantPoint>& points,
                                   const std::stop_token& stop) {
    if (!project.gauge->position_mm) {
        return {};
    }
    const auto sections = static_cast<std::size_t>(project.sections);
    if (project.gauge->compliance_mm_per_n) {
        return std::vector<double>(sections, *project.gauge->compliance_mm_per_n);
    }
    return influenceRows(project, {points.back().position_mm}, positionsOf(points, sections), stop);
}

CoupledSections balance(const Project& project, const std::vector<CompliantPoint>& points,
                        const std::stop_token& stop) {
    const auto sections = static_cast<std::size_t>(project.sections);
    const std::vector<double> middles = positionsOf(points, sections);
    const std::vector<double> widths(sections, project.part->length_mm / project.sections);
    return {influenceRows(project, middles, middles, stop), widths, forceLaw(project),
            wheelContact(project)};
}

} // namespace

SectionCoupling::SectionCoupling(const Project& project, const std::vector<CompliantPoint>& points,
                                 const Blank& blank, const std::stop_token& stop)
    : m_radii(blank.depth_mm.size())
    , m_sections(static_cast<std::size_t>(project.sections))
    , m_points(points.size())
    , m_sliceWidth(project.part->length_mm / project.sections)
    , m_law(forceLaw(project))
    , m_contact(wheelContact(project))
    , m_balance(balance(project, points, stop))
    , m_gaugeInfluence(gaugeInfluence(project, points, stop))
    , m_roots(m_radii * m_sections)
    , m_lag(m_sections)
    , m_wheelSpeed_m_s(project.machine->wheel_speed_m_s)
    , m_peaks(project.cycle->stages.size()) {
    for (std::size_t point = 0; point < m_points; ++point) {
        const std::vector<double>& depths = blank.depthAt(placeOfPoint(project, point));
        m_depth.insert(m_depth.end(), depths.begin(), depths.end());
    }
}

SectionCoupling::Outcome SectionCoupling::solve(const PassFeed& feed, const Place& at,
                                                CutWidth& width, const std::stop_token& stop) {
    for (std::size_t k = 0; k < m_radii; ++k) {
        if (stop.stop_requested()) {
            return Outcome::stopped;
        }
        const double fed = feed.at(static_cast<double>(k + 1) / static_cast<double>(m_radii));
        for (std::size_t j = 0; j < m_sections; ++j) {
            m_lag[j] = fed - m_depth[j * m_radii + k];
        }
        double* roots = m_roots.data() + k * m_sections;
        if (!m_balance.solve(m_lag.data(), roots, stop).converged) {
            return stop.stop_requested() ? Outcome::stopped : Outcome::notSolved;
        }
        keepPeaks(roots, at);
        for (std::size_t j = 0; j < m_sections; ++j) {
            impose(j * m_radii + k, roots[j], m_lag[j], width);
        }
        if (!m_gaugeInfluence.empty()) {
            const std::size_t lane = m_sections * m_radii + k;
            const double lag = fed - m_depth[lane];
            m_gaugeRoot = gaugeRoot(lag, m_gaugeRoot);
            impose(lane, m_gaugeRoot, lag, width);
        }
    }
    return Outcome::solved;
}

double SectionCoupling::gaugeRoot(double lag_mm, double from) const {
    double a = lag_mm;
    for (std::size_t l = 0; l < m_sections; ++l) {
        a -= m_gaugeInfluence[l] * m_balance.sliceForces_n()[l];
    }
    if (m_contact) {
        const double width = m_sliceWidth * static_cast<double>(m_sections);
        return m_contact->root({1, 0, width * m_law.ks, width * m_law.kr}, a, from);
    }
    return std::sqrt(std::max(0.0, a));
}

// The pass computes q = √(C² + 4A·h) and u = (q − C)/(2A), or 2h/(C + q) with a very dull wheel:
// with C = 4A = 0 and the right C² both give the root that is asked for.
void SectionCoupling::impose(std::size_t lane, double root, double lag_mm, CutWidth& width) {
    LaneCoefficients& lanes = width.coefficients;
    lanes.C[lane] = 0;
    lanes.A4[lane] = 0;
    lanes.inverse2A[lane] = 1;
    if (width.bkr > multipliedFormLimit * width.bks) {
        const double q = 2 * lag_mm / root; // no root: infinite, and 2h/q is none again
        lanes.C2[lane] = root > 0 ? q * q : std::numeric_limits<double>::infinity();
    } else {
        lanes.C2[lane] = root * root;
    }
    m_depth[lane] += root * root;
}

void SectionCoupling::keepPeaks(const double* roots, const Place& at) {
    double force = 0;
    double tangential = 0;
    std::size_t deepest = 0;
    for (std::size_t j = 0; j < m_sections; ++j) {
        force += m_law.normal(m_sliceWidth, roots[j]);
        tangential += m_law.tangential(m_sliceWidth, roots[j]);
        deepest = roots[j] > roots[deepest] ? j : deepest;
    }
    Place place = at;
    place.section = static_cast<int>(deepest);
    const auto keep = [&place](Peak& peak, double value) {
        if (value > peak.value) {
            peak = {value, place};
        }
    };
    StagePeaks& peaks = m_peaks[static_cast<std::size_t>(at.stage - 1)];
    keep(peaks.normalForce_n, force);
    keep(peaks.power_w, tangential * m_wheelSpeed_m_s);
}

void SectionCoupling::putPeaks(SimulationResult& result) const {
    for (std::size_t stage = 0; stage < m_peaks.size(); ++stage) {
        result.sumsByStage[stage].normalForce_n = m_peaks[stage].normalForce_n;
        result.sumsByStage[stage].power_w = m_peaks[stage].power_w;
    }
    keepLargestPeaks(result);
}

} // namespace sparkout
