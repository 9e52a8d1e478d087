// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/coupled_plunge.h"
#include "core/simulation/run.h"
#include "core/units.h"

#include <algorithm>
#include <optional>

namespace sparkout {

namespace {

std::vector<double> infeeds(const Project& project) {
    std::vector<double> feeds;
    for (const Stage& stage : project.cycle.stages) {
        feeds.push_back(stage.radial_feed_mm_min.value_or(0) / project.machine.work_speed_rpm);
    }
    return feeds;
}

/// The sections, and after them the free gauge position if there is one.
std::vector<CompliantPoint> points(const Project& project) {
    std::vector<CompliantPoint> sections = compliantPoints(project);
    if (project.gauge.position_mm) {
        sections.push_back(freeGaugePoint(project, sections));
    }
    return sections;
}

/// One cycle of revolutions: all sections are fed by the same t_П, each for itself or coupled
/// [MODEL-6].
class PlungeCycle {
public:
    PlungeCycle(const Project& project, Trajectory* trajectory, const std::stop_token& stop)
        : m_project(project)
        , m_sections(static_cast<std::size_t>(project.sections))
        , m_hasFreeGauge(project.gauge.position_mm.has_value())
        , m_stop(stop)
        , m_run(project, points(project), trajectory, stop)
        , m_control(project, infeeds(project), m_run.blank().totalInfeed_mm)
        , m_width(m_run.makeCut(project.part.length_mm))
        , m_places(m_sections) {
        for (std::size_t j = 0; j < m_places.size(); ++j) {
            m_places[j].section = static_cast<int>(j);
        }
        if (isCoupled(project)) {
            m_coupling.emplace(project, points(project), m_run.blank());
        }
    }

    SimulationResult run() {
        const std::size_t gaugePoint =
            m_hasFreeGauge ? m_sections : static_cast<std::size_t>(gaugeSection(m_project));
        while (!m_control.finished() && !m_run.mustEnd()) {
            const bool waits = m_control.waitsForSize();
            const bool retracts = m_control.retracts();
            const std::size_t stage = m_control.stage();
            if (!revolution()) {
                break; // in the middle of a revolution, which then does not count
            }
            m_control.stepDone(m_run.remaining(gaugePoint), m_run.fed_mm);
            const double root = m_run.takeLargestRoot();
            if (retracts && m_control.stage() == stage && root * root <= noProgress_mm) {
                m_control.endStage();
            }
            m_idle = waits && root * root <= noProgress_mm ? m_idle + 1 : 0;
            if (!m_control.finished() && m_idle >= idleRevolutions) {
                m_run.setStatus(RunStatus::cannotReachSize);
                break;
            }
        }
        SimulationResult result = m_run.finish(m_control, gaugePoint, m_sections, {Zone::section});
        if (m_coupling) {
            m_coupling->putPeaks(result);
        }
        return result;
    }

private:
    static constexpr int idleRevolutions = 100;

    /// t_П + (S_p/n)·(k+1)/K for radius k; after the revolution t_П += S_p/n. False: not finished.
    bool revolution() {
        ++m_revolutions;
        const double infeed = m_control.nextInfeed(m_run.fed_mm);
        for (Place& place : m_places) {
            place.stage = static_cast<int>(m_control.stage()) + 1;
            place.cycleCount = m_revolutions;
        }
        const double duration = units::secondsPerMinute / m_project.machine.work_speed_rpm;
        const PassFeed feed{m_run.fed_mm, 0, infeed, std::max(infeed, 0.0)};
        if (m_coupling && !couple(feed)) {
            return false;
        }
        m_run.cut(0, m_sections, m_width, feed, m_places.data(),
                  {.duration_s = duration, .radialFeed_mm = infeed});
        if (m_hasFreeGauge) {
            m_run.cut(m_sections, 1, m_width, feed, nullptr, {});
        }
        m_run.fed_mm += infeed;
        m_run.advance(duration, m_control.stage());
        return true;
    }

    bool couple(const PassFeed& feed) {
        switch (m_coupling->solve(feed, m_places.front(), m_width, m_stop)) {
        case SectionCoupling::Outcome::solved: return true;
        case SectionCoupling::Outcome::notSolved: m_run.setStatus(RunStatus::notSolved); break;
        case SectionCoupling::Outcome::stopped: m_run.setStatus(RunStatus::stopped); break;
        }
        return false;
    }

    const Project& m_project;
    std::size_t m_sections;
    bool m_hasFreeGauge;
    std::stop_token m_stop;
    Run m_run;
    StageControl m_control;
    CutWidth m_width;
    std::vector<Place> m_places;
    std::optional<SectionCoupling> m_coupling; ///< with sections coupled
    int m_revolutions = 0;
    int m_idle = 0; ///< revolutions in a row that removed nothing
};

} // namespace

SimulationResult simulatePlunge(const Project& project, Trajectory* trajectory,
                                const std::stop_token& stop) {
    return PlungeCycle(project, trajectory, stop).run();
}

} // namespace sparkout
