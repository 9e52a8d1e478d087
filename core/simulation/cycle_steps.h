// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/radius_follower.h"
#include "core/simulation/run.h"

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

} // namespace sparkout
