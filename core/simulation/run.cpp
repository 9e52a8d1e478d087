// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include "core/simulation/simulate.h"
#include "core/units.h"
#include "core/version.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sparkout {

Run::Run(const Project& project, std::vector<CompliantPoint> points, Trajectory* trajectory,
         std::stop_token stop)
    : m_project(project)
    , m_blank(makeBlank(project.part))
    , m_radii(project.part.radii_per_section)
    , m_points(std::move(points))
    , m_law(forceLaw(project))
    , m_lanes(m_points.size() * static_cast<std::size_t>(m_radii))
    , m_cutPass(widestPassFunction())
    , m_trajectory(trajectory)
    , m_stop(std::move(stop))
    , m_wheelSpeed_m_s(project.machine.wheel_speed_m_s) {
    const auto K = static_cast<std::size_t>(m_radii);
    for (std::size_t lane = 0; lane < m_lanes.depth_mm.size(); ++lane) {
        const std::size_t k = lane % K;
        m_lanes.depth_mm[lane] = m_blank.depth_mm[k];
        m_lanes.share[lane] = static_cast<double>(k + 1) / m_radii;
    }
    m_result.project = project;
    m_result.project.runs.clear();
    m_result.engineVersion = version;
    m_result.timeByStage_s.assign(project.cycle.stages.size(), 0.0);
    if (m_trajectory) {
        m_trajectory->passes.clear(); // keeps what the caller has reserved
        m_trajectory->visits.clear();
        m_trajectory->radii = m_radii;
    }
}

CutWidth Run::makeCut(double width_mm) const {
    CutWidth cut(m_lanes.depth_mm.size());
    setWidth(cut, width_mm);
    return cut;
}

void Run::setWidth(CutWidth& cut, double width_mm) const {
    cut.width_mm = width_mm;
    cut.bks = width_mm * m_law.ks;
    cut.bkr = width_mm * m_law.kr;
    for (std::size_t lane = 0; lane < m_lanes.depth_mm.size(); ++lane) {
        const std::size_t point = lane / static_cast<std::size_t>(m_radii);
        cut.coefficients.set(lane, m_points[point].gamma_mm_n, cut.bks, cut.bkr);
    }
}

void Run::cut(std::size_t first, std::size_t count, const CutWidth& width, const PassFeed& feed,
              const Place* places, const PassInfo& info) {
    const auto K = static_cast<std::size_t>(m_radii);
    const PassRange range{first * K, count * K, width.bks, width.bkr};
    const double root = m_cutPass(m_lanes, width.coefficients, feed, range);
    m_result.visits += static_cast<long long>(range.count);
    m_largestRoot = std::max(m_largestRoot, root);
    if (!places) {
        return;
    }
    keepPeak(root, first, count, width, places);
    if (m_trajectory) {
        for (std::size_t i = 0; i < count; ++i) {
            record(first + i, width, feed, places[i], info);
        }
    }
}

// Both forces rise with a at one width, so the pass's largest √a carries both peaks.
void Run::keepPeak(double root, std::size_t first, std::size_t count, const CutWidth& width,
                   const Place* places) {
    const double normal = m_law.normal(width.width_mm, root);
    const double power = m_law.tangential(width.width_mm, root) * m_wheelSpeed_m_s;
    if (normal <= m_result.peakNormalForce_n && power <= m_result.peakPower_w) {
        return;
    }
    const auto begin = m_lanes.root.begin()
                       + static_cast<std::ptrdiff_t>(first * static_cast<std::size_t>(m_radii));
    const auto found = std::find(
        begin, begin + static_cast<std::ptrdiff_t>(count * static_cast<std::size_t>(m_radii)),
        root);
    const Place& place = places[(found - begin) / m_radii];
    if (normal > m_result.peakNormalForce_n) {
        m_result.peakNormalForce_n = normal;
        m_result.peakNormalForceAt = place;
    }
    if (power > m_result.peakPower_w) {
        m_result.peakPower_w = power;
        m_result.peakPowerAt = place;
    }
}

void Run::record(std::size_t point, const CutWidth& width, const PassFeed& feed, const Place& place,
                 const PassInfo& info) {
    Trajectory& trajectory = *m_trajectory;
    trajectory.passes.push_back({place, m_result.time_s, info.duration_s, width.width_mm,
                                 info.axialFeed_mm_min, info.radialFeed_mm,
                                 trajectory.visits.size()});
    const bool stroke = info.axialFeed_mm_min > 0;
    for (int k = 0; k < m_radii; ++k) {
        const std::size_t lane =
            point * static_cast<std::size_t>(m_radii) + static_cast<std::size_t>(k);
        const double share = m_lanes.share[lane];
        const double u = m_lanes.root[lane];
        Visit visit;
        visit.time_s = m_result.time_s + info.duration_s * (stroke ? 1.0 : share);
        visit.programmed_mm = feed.base + std::min(feed.offset + feed.rate * share, feed.cap);
        visit.actual_mm = u * u;
        visit.accumulated_mm =
            m_lanes.depth_mm[lane] - m_blank.depth_mm[static_cast<std::size_t>(k)];
        visit.radius_mm = radiusAt(m_lanes.depth_mm[lane]);
        visit.normalForce_n = m_law.normal(width.width_mm, u);
        trajectory.visits.push_back(visit);
    }
}

double Run::radiusAt(double depth_mm) const {
    return m_project.part.surface == Surface::external ? m_blank.firstTouchRadius_mm - depth_mm
                                                       : m_blank.firstTouchRadius_mm + depth_mm;
}

double Run::remaining(std::size_t point) const {
    return remainingStock(m_lanes.depth_mm.data() + point * static_cast<std::size_t>(m_radii),
                          m_radii, m_project.gauge.rule, m_blank.totalInfeed_mm);
}

double Run::takeLargestRoot() {
    return std::exchange(m_largestRoot, 0.0);
}

bool Run::mustEnd() {
    if (m_stop.stop_requested()) {
        m_result.status = RunStatus::stopped;
        return true;
    }
    if (m_result.visits > maxVisits) {
        m_result.status = RunStatus::tooLong;
        return true;
    }
    return false;
}

SectionResult Run::sectionResult(std::size_t point, Zone zone) const {
    const auto K = static_cast<std::size_t>(m_radii);
    SectionResult section;
    section.zone = zone;
    section.position_mm = m_points[point].position_mm;
    section.compliance_mm_per_n = m_points[point].gamma_mm_n;
    for (std::size_t k = 0; k < K; ++k) {
        section.radii_mm.push_back(radiusAt(m_lanes.depth_mm[point * K + k]));
        section.peakNormalForce_n =
            std::max(section.peakNormalForce_n, m_lanes.peakForce_n[point * K + k]);
    }
    const auto [low, high] = std::minmax_element(section.radii_mm.begin(), section.radii_mm.end());
    section.radialRunout_mm = *high - *low + m_project.machine.geometric_runout_um / units::umPerMm;
    const double nominal = m_project.part.diameter_mm;
    section.diameterDeviationMin_mm = section.radii_mm[0] + section.radii_mm[K / 2] - nominal;
    section.diameterDeviationMax_mm = section.diameterDeviationMin_mm;
    for (std::size_t k = 1; k < K / 2; ++k) {
        const double deviation = section.radii_mm[k] + section.radii_mm[k + K / 2] - nominal;
        section.diameterDeviationMin_mm = std::min(section.diameterDeviationMin_mm, deviation);
        section.diameterDeviationMax_mm = std::max(section.diameterDeviationMax_mm, deviation);
    }
    return section;
}

SimulationResult Run::finish(const StageControl& control, std::size_t gaugePoint,
                             std::size_t reported, const std::vector<Zone>& zones) {
    m_result.countsByStage = control.stepsByStage();
    for (const int count : m_result.countsByStage) {
        m_result.cycleCount += count;
    }
    for (std::size_t point = 0; point < reported; ++point) {
        m_result.sections.push_back(sectionResult(point, zones[std::min(point, zones.size() - 1)]));
    }
    m_result.remainingStock_mm = remaining(gaugePoint);
    const double side = m_project.part.surface == Surface::external ? 1 : -1;
    m_result.gaugeReading_mm = 2 * (m_blank.targetRadius_mm + side * m_result.remainingStock_mm);
    return std::move(m_result);
}

SimulationResult simulate(const Project& project, Trajectory* trajectory,
                          const std::stop_token& stop) {
    return project.operation == Operation::traverse ? simulateTraverse(project, trajectory, stop)
                                                    : simulatePlunge(project, trajectory, stop);
}

} // namespace sparkout
