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

/// What the next step of a cycle feeds: one double stroke (traverse) or one revolution (plunge).
struct StepFeed {
    double infeed_mm = 0;
    std::size_t stage = 0;       ///< that it belongs to, from 0
    double axialFeed_mm_min = 0; ///< traverse
    /// Traverse: S_c, which is fed until t_П is `most_mm`, or where it is already.
    double continuousFeed_mm_min = 0;
    double most_mm = std::numeric_limits<double>::infinity();
};

/// The steps of a cycle without what decides on stages: simulate() adds the stage control, a
/// search goes on from one state in many ways. What a step does depends on the state and its feed
/// alone. The project's stages count, for their number; it must outlive the steps and copies.
class CycleSteps {
public:
    virtual ~CycleSteps() = default;
    [[nodiscard]] virtual std::unique_ptr<CycleSteps> copy() const = 0;
    /// False: the run must end within the step, which then does not count.
    [[nodiscard]] virtual bool step(const StepFeed& feed) = 0;
    /// What the gauge reads: remaining stock per side [mm].
    [[nodiscard]] double remaining() const { return m_run.remaining(m_gaugePoint); }
    [[nodiscard]] virtual SimulationResult finish(const std::vector<int>& stepsByStage) = 0;
    /// Of the state it is in when asked to begin; none where radii depend on each other.
    [[nodiscard]] virtual const RadiusFollower* follower() const { return nullptr; }
    [[nodiscard]] std::size_t gaugePoint() const { return m_gaugePoint; }

    [[nodiscard]] Run& run() { return m_run; }
    [[nodiscard]] const Run& run() const { return m_run; }

protected:
    CycleSteps(Run run, std::size_t gaugePoint) : m_run(std::move(run)), m_gaugePoint(gaugePoint) {}
    CycleSteps(const CycleSteps&) = default;

    Run m_run;
    std::size_t m_gaugePoint;
    int m_steps = 0; ///< begun so far
};

} // namespace sparkout
