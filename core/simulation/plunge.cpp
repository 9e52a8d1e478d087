// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/plunge.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/coupled_plunge.h"
#include "core/simulation/cycle_loop.h"
#include "core/units.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// The sections, followed by the free gauge position if there is one.
std::vector<CompliantPoint> points(const Project& project, const std::stop_token& stop) {
    std::vector<CompliantPoint> sections = compliantPoints(project, stop);
    if (project.gauge->position_mm) {
        sections.push_back(freeGaugePoint(project, sections, stop));
    }
    return sections;
}

/// Makes revolutions: all sections are fed to the same t_П, independent or coupled [MODEL-6].
class PlungeSteps : public CycleSteps, public RadiusFollower {
public:
    PlungeSteps(const Project& project, Trajectory* trajectory, const std::stop_token& stop)
        : CycleSteps(Run(project, points(project, stop), trajectory, stop), gaugePoint(project))
        , m_project(project)
        , m_sections(static_cast<std::size_t>(project.sections))
        , m_hasFreeGauge(project.gauge->position_mm.has_value())
        , m_stop(stop)
        , m_width(std::make_shared<CutWidth>(m_run.makeCut(project.part->length_mm)))
        , m_places(m_sections) {
        for (std::size_t j = 0; j < m_places.size(); ++j) {
            m_places[j].section = static_cast<int>(j);
        }
        if (isCoupled(project)) {
            m_coupling.emplace(project, points(project, stop), m_run.blank(), stop);
            SectionCoupling::takeOver(*m_width);
        }
        if (!m_coupling && !m_hasFreeGauge && m_run.isEachAlone()) {
            auto balances = std::make_shared<std::vector<LaneBalance>>();
            for (std::size_t j = 0; j < m_sections; ++j) {
                balances->push_back(m_run.balance(j, project.part->length_mm));
            }
            m_balances = std::move(balances);
        }
    }

    std::unique_ptr<CycleSteps> copy() const override {
        auto other = std::make_unique<PlungeSteps>(*this);
        if (m_coupling) {
            other->m_width = std::make_shared<CutWidth>(*m_width);
        }
        return other;
    }

    /// t_П + (S_p/n)·(k+1)/K for radius k; after the revolution t_П += S_p/n.
    bool step(const StepFeed& step) override {
        ++m_steps;
        const double infeed = step.infeed_mm;
        for (Place& place : m_places) {
            place.stage = static_cast<int>(step.stage) + 1;
            place.cycleCount = m_steps;
        }
        const double duration = units::secondsPerMinute / m_project.machine->work_speed_rpm;
        const PassFeed feed = m_run.withWave(revolution(m_run.fed_mm, infeed));
        if (m_coupling && !couple(feed)) {
            return false;
        }
        m_run.cut(0, m_sections, *m_width, feed, m_places.data(),
                  {.duration_s = duration, .radialFeed_mm = infeed});
        if (m_hasFreeGauge) {
            m_run.cut(m_sections, 1, *m_width, feed, nullptr, {});
        }
        const double fedBefore_mm = m_run.fed_mm, before_s = m_run.time_s();
        m_run.fed_mm += infeed;
        m_run.advance(duration, step.stage);
        m_run.stepDone(fedBefore_mm, before_s, step.stage);
        return true;
    }

    SimulationResult finish(const std::vector<int>& stepsByStage) override {
        SimulationResult result =
            m_run.finish(stepsByStage, m_gaugePoint, m_sections, {Zone::section});
        if (m_coupling) {
            m_coupling->putPeaks(result);
        }
        return result;
    }

    /// The free gauge position has no requirements, and a follower does not distinguish it from
    /// sections.
    const RadiusFollower* follower() const override { return m_balances ? this : nullptr; }
    FollowedRadii follow(const FollowedRadii::Lanes& lanes) const override {
        return radiiOf(m_run, lanes);
    }
    FollowedFeed feed(const StepFeed& step) const override {
        return {.infeed_mm = step.infeed_mm, .all_mm = step.infeed_mm, .strokes = {}};
    }
    void stepAlone(FollowedRadii& radii, const FollowedFeed& feed) const override {
        const PassFeed pass = revolution(radii.fed_mm, feed.infeed_mm);
        for (FollowedRadius& radius : radii.radii) {
            cutAlone(radius, (*m_balances)[radius.zone], pass.at(radius.share));
        }
        radii.fed_mm += feed.infeed_mm;
        ++radii.passes;
    }
    void strokesAlone(FollowedRadii& radii, const FollowedFeed& feed) const override {
        stepAlone(radii, feed);
    }
    bool hasStrokesAlone() const override { return true; }

private:
    static PassFeed revolution(double fed_mm, double infeed_mm) {
        return {fed_mm, 0, infeed_mm, std::max(infeed_mm, 0.0)};
    }

    static std::size_t gaugePoint(const Project& project) {
        return static_cast<std::size_t>(project.gauge->position_mm ? project.sections
                                                                   : gaugeSection(project));
    }

    bool couple(const PassFeed& feed) {
        switch (m_coupling->solve(m_run, feed, m_places.front(), *m_width, m_stop)) {
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
    std::shared_ptr<CutWidth> m_width; ///< shared by all copies, unless the coupling changes it
    std::vector<Place> m_places;
    std::shared_ptr<const std::vector<LaneBalance>> m_balances; ///< by section; null: no follower
    std::optional<SectionCoupling> m_coupling;                  ///< only with coupled sections
};

} // namespace

std::unique_ptr<CycleSteps> plungeSteps(const Project& project, Trajectory* trajectory,
                                        const std::stop_token& stop) {
    return std::make_unique<PlungeSteps>(project, trajectory, stop);
}

SimulationResult simulatePlunge(const Project& project, Trajectory* trajectory,
                                const std::stop_token& stop) {
    const std::unique_ptr<CycleSteps> steps = plungeSteps(project, trajectory, stop);
    return runCycle(project, *steps);
}

} // namespace sparkout
