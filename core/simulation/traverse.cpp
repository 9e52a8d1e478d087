// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout {

namespace {

/// A dwell in whole revolutions: ⌊x + 0.5 + 1e-9⌋, at least 1 when there is a dwell [MODEL-5].
int dwellRevolutions(double dwell_s, double workSpeed_rpm) {
    if (dwell_s <= 0) {
        return 0;
    }
    const double x = dwell_s / units::secondsPerMinute * workSpeed_rpm;
    return std::max(1, static_cast<int>(std::floor(x + 0.5 + 1e-9)));
}

std::vector<double> infeedsOfStages(const Project& project) {
    std::vector<double> feeds;
    for (const Stage& stage : project.cycle.stages) {
        feeds.push_back(stage.radial_feed_mm.value_or(0));
    }
    return feeds;
}

/// One cycle of double strokes, step by step in the order of the table in MODEL-5.
class TraverseCycle {
public:
    TraverseCycle(const Project& project, Zone gaugeZone, Trajectory* trajectory,
                  const std::stop_token& stop)
        : m_project(project)
        , m_gaugeZone(static_cast<std::size_t>(gaugeZone))
        , m_run(project, compliantPoints(project), trajectory, stop)
        , m_control(project, infeedsOfStages(project), m_run.blank().totalInfeed_mm)
        , m_plunge1(m_run.makeCut(zoneLengths(project).rz1))
        , m_plunge2(m_run.makeCut(zoneLengths(project).rz2))
        , m_stroke(m_run.makeCut(0))
        , m_entryDwell(dwellRevolutions(project.machine.dwell_entry_s, rpm()))
        , m_exitDwell(dwellRevolutions(project.machine.dwell_exit_s, rpm()))
        , m_travel_mm(project.part.length_mm - project.wheel.width_mm
                      + project.machine.overrun_entry_mm + project.machine.overrun_exit_mm) {}

    SimulationResult run() {
        std::size_t preparedStage = m_project.cycle.stages.size();
        while (!m_control.finished() && !m_run.mustEnd()) {
            if (m_control.stage() != preparedStage) {
                preparedStage = m_control.stage();
                prepareStage();
            }
            const bool waits = m_control.waitsForSize();
            doubleStroke();
            if (m_run.mustEnd()) {
                break; // in the middle of a double stroke, which then does not count
            }
            m_control.stepDone(m_run.remaining(m_gaugeZone), m_run.fed_mm);
            const double root = m_run.takeLargestRoot();
            if (waits && !m_control.finished() && root * root <= noProgress_mm) {
                m_run.setStatus(RunStatus::cannotReachSize);
                break;
            }
        }
        return m_run.finish(m_control, m_gaugeZone, zoneCount, {Zone::rz1, Zone::nz, Zone::rz2});
    }

private:
    static constexpr std::size_t zoneCount = 3;

    double rpm() const { return m_project.machine.work_speed_rpm; }
    double revolution_s() const { return units::secondsPerMinute / rpm(); }

    void prepareStage() {
        m_axialFeed = *m_project.cycle.stages[m_control.stage()].axial_feed_mm_min;
        m_run.setWidth(m_stroke, std::min(m_axialFeed / rpm(), m_project.wheel.width_mm));
    }

    Place place(Zone zone, Step step, int revolution = 1) const {
        return {.zone = zone,
                .step = step,
                .section = static_cast<int>(zone),
                .stage = static_cast<int>(m_control.stage()) + 1,
                .cycleCount = m_strokes,
                .revolution = revolution};
    }

    void doubleStroke() {
        ++m_strokes;
        const double infeed = m_control.nextInfeed(m_run.fed_mm);
        plungeIn(infeed);
        dwell(Zone::rz1, Step::e2, m_plunge1, m_entryDwell);
        stroke({Step::e3, Step::e1, Step::e1});
        dwell(Zone::rz2, Step::e2, m_plunge2, m_exitDwell);
        stroke({Step::e4, Step::e2, Step::e3});
        dwell(Zone::rz1, Step::e5, m_plunge1, m_entryDwell);
    }

    /// E1 of РЗ1: t_П + min(S_t, (S_rad/n)·(m − 1 + (k+1)/K)) in N_E1 = ⌈n·S_t/S_rad⌉ revolutions.
    void plungeIn(double infeed) {
        m_infeed = infeed;
        const double feed = m_project.machine.plunge_feed_mm_min;
        const int revolutions = static_cast<int>(std::ceil(rpm() * infeed / feed - 1e-9));
        const double perRevolution = feed / rpm();
        for (int m = 1; m <= revolutions && !m_run.mustEnd(); ++m) {
            const Place at = place(Zone::rz1, Step::e1, m);
            m_run.cut(0, 1, m_plunge1,
                      {m_run.fed_mm, perRevolution * (m - 1), perRevolution, infeed}, &at,
                      {.duration_s = revolution_s(), .radialFeed_mm = infeed});
            m_run.advance(revolution_s(), m_control.stage());
        }
        m_run.fed_mm += infeed;
    }

    void dwell(Zone zone, Step step, const CutWidth& width, int revolutions) {
        for (int m = 1; m <= revolutions && !m_run.mustEnd(); ++m) {
            const Place at = place(zone, step, m);
            m_run.cut(static_cast<std::size_t>(zone), 1, width, {.base = m_run.fed_mm}, &at,
                      {.duration_s = revolution_s(), .radialFeed_mm = m_infeed});
            m_run.advance(revolution_s(), m_control.stage());
        }
    }

    void stroke(const std::array<Step, zoneCount>& steps) {
        const double duration = m_travel_mm / m_axialFeed * units::secondsPerMinute;
        const std::array places{place(Zone::rz1, steps[0]), place(Zone::nz, steps[1]),
                                place(Zone::rz2, steps[2])};
        m_run.cut(
            0, zoneCount, m_stroke, {.base = m_run.fed_mm}, places.data(),
            {.duration_s = duration, .axialFeed_mm_min = m_axialFeed, .radialFeed_mm = m_infeed});
        m_run.advance(duration, m_control.stage());
    }

    const Project& m_project;
    std::size_t m_gaugeZone; ///< the gauge stands in its middle
    Run m_run;
    StageControl m_control;
    CutWidth m_plunge1, m_plunge2, m_stroke;
    int m_entryDwell, m_exitDwell;
    double m_travel_mm;
    double m_axialFeed = 0;
    double m_infeed = 0; ///< of the running double stroke
    int m_strokes = 0;
};

} // namespace

SimulationResult simulateTraverse(const Project& project, Trajectory* trajectory,
                                  const std::stop_token& stop) {
    return TraverseCycle(project, Zone::nz, trajectory, stop).run();
}

SimulationResult simulateTraverseGaugedIn(Zone zone, const Project& project,
                                          const std::stop_token& stop) {
    return TraverseCycle(project, zone, nullptr, stop).run();
}

} // namespace sparkout
