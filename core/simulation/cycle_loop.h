// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/radius_follower.h"
#include "core/simulation/run.h"
#include "core/simulation/stage_control.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// Feed of one step of a cycle: a double stroke (traverse) or a revolution (plunge).
struct StepFeed {
    double infeed_mm = 0;
    std::size_t stage = 0;       ///< stage to which it belongs, from 0
    double axialFeed_mm_min = 0; ///< traverse
    /// Traverse: S_c, which feeds until t_П reaches `most_mm`, and not at all beyond it.
    double continuousFeed_mm_min = 0;
    double most_mm = std::numeric_limits<double>::infinity();
};

/// The steps of a cycle without the control of its stages: simulate() adds the stage control, a
/// search continues one state in many ways. A step depends only on the state and its feed. The
/// project is used for the number of its stages; it must outlive the steps and their copies.
class CycleSteps {
public:
    virtual ~CycleSteps() = default;
    [[nodiscard]] virtual std::unique_ptr<CycleSteps> copy() const = 0;
    /// Makes a step; returns false if the run must end within the step, which then does not count.
    [[nodiscard]] virtual bool step(const StepFeed& feed) = 0;
    /// Returns the remaining stock per side that the gauge reads [mm].
    [[nodiscard]] double remaining() const { return m_run.remaining(m_gaugePoint); }
    [[nodiscard]] virtual SimulationResult finish(const std::vector<int>& stepsByStage) = 0;
    /// Returns a follower of radii from the current state; null if radii depend on each other.
    [[nodiscard]] virtual const RadiusFollower* follower() const { return nullptr; }
    [[nodiscard]] std::size_t gaugePoint() const { return m_gaugePoint; }

    [[nodiscard]] Run& run() { return m_run; }
    [[nodiscard]] const Run& run() const { return m_run; }

protected:
    CycleSteps(Run run, std::size_t gaugePoint) : m_run(std::move(run)), m_gaugePoint(gaugePoint) {}
    CycleSteps(const CycleSteps&) = default;

    Run m_run;
    std::size_t m_gaugePoint;
    int m_steps = 0; ///< number of steps begun so far
};

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
