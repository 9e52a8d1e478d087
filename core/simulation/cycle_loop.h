// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/cycle_steps.h"
#include "core/simulation/stage_control.h"

#include <cstddef>

namespace sparkout {

/// Readings at the end of a step.
struct StepReading {
    double remaining_mm = 0; ///< stock per side, by the gauge
    double fed_mm = 0;       ///< t_П
    double time_s = 0;
    double root = 0; ///< largest √a of the step [√mm]
};

[[nodiscard]] StepReading takeReading(CycleSteps& steps);

/// Controls a cycle step by step: the feed of the next step, and whether the cycle has ended or
/// cannot end.
class CycleLoop {
public:
    /// The project must outlive the loop and its copies.
    CycleLoop(const Project& project, const Run& run);

    [[nodiscard]] bool finished() const { return m_control.finished(); }
    /// Returns whether the cycle waits for a size that it cannot reach.
    [[nodiscard]] bool isStuck() const { return m_isStuck; }
    [[nodiscard]] const StageControl& control() const { return m_control; }
    /// Ends the running stage whatever the control requires.
    void endStage() { m_control.endStage(); }

    /// Returns the feed of the next step.
    [[nodiscard]] StepFeed next(const Run& run) const;
    /// Takes the reading after that step. If the stock decides, `decide` returns whether the stock
    /// is larger by at most its argument [mm].
    template <class Decide>
    void stepDone(const StepReading& reading, const Decide& decide) {
        const std::size_t stage = m_control.stage();
        const bool waits = m_control.waitsForSize(), retracts = m_control.retracts();
        m_control.read(reading.remaining_mm, reading.time_s);
        while (!finished() && decide(m_control.overBy(reading.fed_mm))) {
            m_control.endStage();
        }
        const bool isIdle = reading.root * reading.root <= noProgress_mm;
        if (retracts && isIdle && m_control.stage() == stage) {
            m_control.endStage();
        }
        m_idle = waits && isIdle ? m_idle + 1 : 0;
        m_isStuck = !finished() && m_idle >= m_mostIdle && !decide(m_control.dueBy());
    }

private:
    const Project* m_project;
    StageControl m_control;
    int m_mostIdle; ///< allowed number of successive steps that remove nothing
    int m_idle = 0;
    bool m_isStuck = false;
};

/// Runs the cycle of a project with the steps of its operation.
[[nodiscard]] SimulationResult runCycle(const Project& project, CycleSteps& steps);

} // namespace sparkout
