// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/cycle_steps.h"
#include "core/simulation/stage_control.h"

#include <cstddef>

namespace sparkout {

/// What is known of a step that is done.
struct StepReading {
    double remaining_mm = 0; ///< stock per side, as the gauge reads it
    double fed_mm = 0;       ///< t_П
    double time_s = 0;
    double root = 0; ///< largest √a of the step [√mm]
};

[[nodiscard]] StepReading takeReading(CycleSteps& steps);

/// Decides on a cycle step by step: what is fed next, and whether the cycle has ended or cannot.
class CycleLoop {
public:
    /// The project must outlive the loop and its copies.
    CycleLoop(const Project& project, const Run& run);

    [[nodiscard]] bool finished() const { return m_control.finished(); }
    /// Whether it waits for a size it cannot reach.
    [[nodiscard]] bool isStuck() const { return m_isStuck; }
    [[nodiscard]] const StageControl& control() const { return m_control; }
    /// Ends the running stage, whatever the control says.
    void endStage() { m_control.endStage(); }

    /// What the next step feeds.
    [[nodiscard]] StepFeed next(const Run& run) const;
    /// After that step. `decide` answers where the stock decides: whether it is larger by no more
    /// than so much [mm].
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
    int m_mostIdle; ///< steps in a row that remove nothing
    int m_idle = 0;
    bool m_isStuck = false;
};

/// The cycle of a project, with the steps of its kind.
[[nodiscard]] SimulationResult runCycle(const Project& project, CycleSteps& steps);

} // namespace sparkout
