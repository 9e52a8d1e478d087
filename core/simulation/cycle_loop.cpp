// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/cycle_loop.h"

#include "core/project/cycle.h"

namespace sparkout {

namespace {

/// A double stroke visits each radius many times, a revolution once: in a plunge the form of the
/// blank may cause successive revolutions without removal.
constexpr int idleDoubleStrokes = 1, idleRevolutions = 100;

} // namespace

CycleLoop::CycleLoop(const Project& project, const Run& run)
    : m_project(&project)
    , m_control(project, infeedsOfStages(project), run.blank().totalInfeed_mm)
    , m_mostIdle(project.operation->travels ? idleDoubleStrokes : idleRevolutions) {}

StepFeed CycleLoop::next(const Run& run) const {
    const Stage& stage = m_project->cycle->stages[m_control.stage()];
    return {m_control.nextInfeed(run.fed_mm), m_control.stage(),
            stage.axial_feed_mm_min.value_or(0),
            m_project->operation->travels ? stage.continuousFeed_mm_min() : 0, m_control.mostFed()};
}

StepReading takeReading(CycleSteps& steps) {
    Run& run = steps.run();
    return {steps.remaining(), run.fed_mm, run.time_s(), run.takeLargestRoot()};
}

SimulationResult runCycle(const Project& project, CycleSteps& steps) {
    CycleLoop loop(project, steps.run());
    while (!loop.finished() && !loop.isStuck() && !steps.run().mustEnd()) {
        if (!steps.step(loop.next(steps.run()))) {
            break; // within a step, which then does not count
        }
        loop.stepDone(takeReading(steps), [](double larger_mm) { return larger_mm >= 0; });
    }
    if (loop.isStuck()) {
        steps.run().setStatus(RunStatus::cannotReachSize);
    }
    return steps.finish(loop.control().stepsByStage());
}

} // namespace sparkout
