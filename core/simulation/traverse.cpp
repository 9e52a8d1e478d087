// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/traverse.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

int dwellRevolutions(double dwell_s, double workSpeed_rpm) {
    if (dwell_s <= 0) {
        return 0;
    }
    const double x = dwell_s / units::secondsPerMinute * workSpeed_rpm;
    return std::max(1, static_cast<int>(std::floor(x + 0.5 + 1e-9)));
}

ReversalFeeds reversalFeeds(ReversalInfeed at, double infeed_mm) {
    switch (at) {
    case ReversalInfeed::entry: break;
    case ReversalInfeed::exit: return {0, infeed_mm};
    case ReversalInfeed::both: return {infeed_mm / 2, infeed_mm / 2};
    }
    return {infeed_mm, 0};
}

int plungeInRevolutions(const Machine& machine, double infeed_mm) {
    return static_cast<int>(
        std::ceil(machine.work_speed_rpm * infeed_mm / machine.plunge_feed_mm_min - 1e-9));
}

namespace {

/// Makes double strokes, step by step in the order of the table in MODEL-5.
class TraverseSteps : public CycleSteps, public RadiusFollower {
public:
    TraverseSteps(const Project& project, Zone gaugeZone, Trajectory* trajectory,
                  const std::stop_token& stop)
        : CycleSteps(Run(project, pointsOf(project, stop), trajectory, stop),
                     static_cast<std::size_t>(gaugeZone))
        , m_project(project)
        , m_inZone(static_cast<std::size_t>(zoneSectionCount(project)) / zoneCount)
        , m_places(zoneCount * m_inZone)
        , m_plunge1(sharedCut(plungeWidth(project, zoneLengths(project).rz1)))
        , m_plunge2(sharedCut(plungeWidth(project, zoneLengths(project).rz2)))
        , m_entryDwell(dwellRevolutions(project.machine->dwell_entry_s, rpm()))
        , m_exitDwell(dwellRevolutions(project.machine->dwell_exit_s, rpm()))
        , m_travel_mm(project.part->length_mm - project.wheel->width_mm
                      + project.machine->overrun_entry_mm + project.machine->overrun_exit_mm) {
        if (m_inZone > 0) {
            m_run.countFrom(zoneCount);
            placeSections();
        }
        for (std::size_t zone = 0; zone < zoneCount; ++zone) {
            m_plungeBalances[zone] =
                m_run.balance(zone, plungeCut(static_cast<Zone>(zone)).width_mm);
        }
    }

    std::unique_ptr<CycleSteps> copy() const override {
        return std::make_unique<TraverseSteps>(*this);
    }

    bool step(const StepFeed& feed) override {
        if (feed.axialFeed_mm_min != m_axialFeed) {
            m_axialFeed = feed.axialFeed_mm_min;
            m_stroke = sharedCut(strokeWidth(m_axialFeed));
        }
        m_stage = feed.stage;
        ++m_steps;
        const StrokeFeed stroke = strokeFeed(feed);
        const double left_mm = std::max(stroke.most_mm - m_run.fed_mm, stroke.infeed_mm);
        const double all_mm = std::min(programmed_mm(stroke), left_mm);
        const double fedBefore_mm = m_run.fed_mm, before_s = m_run.time_s();
        const bool done =
            doubleStroke(m_run.fed_mm, stroke, [&](const Pass& pass) { return cut(pass, all_mm); });
        if (!done) {
            return false;
        }
        m_run.stepDone(fedBefore_mm, before_s, m_stage,
                       m_project.wheel->width_mm / m_stroke->width_mm);
        return !m_run.mustEnd();
    }

    SimulationResult finish(const std::vector<int>& stepsByStage) override {
        return m_run.finish(stepsByStage, m_gaugePoint, zoneCount,
                            {Zone::rz1, Zone::nz, Zone::rz2});
    }

    const RadiusFollower* follower() const override {
        const bool inMiddle = m_gaugePoint == static_cast<std::size_t>(Zone::nz);
        const bool alone = m_run.isEachAlone() && m_inZone == 0;
        return inMiddle && alone ? this : nullptr;
    }

    FollowedRadii follow(const FollowedRadii::Lanes& lanes) const override {
        return radiiOf(m_run, lanes);
    }

    FollowedFeed feed(const StepFeed& step) const override {
        FollowedFeed feed{.infeed_mm = step.infeed_mm,
                          .all_mm = programmed_mm(strokeFeed(step)),
                          .continuousFeed_mm_min = step.continuousFeed_mm_min,
                          .axialFeed_mm_min = step.axialFeed_mm_min,
                          .strokes = {}};
        for (std::size_t zone = 0; zone < zoneCount; ++zone) {
            feed.strokes[zone] = m_run.balance(zone, strokeWidth(step.axialFeed_mm_min));
        }
        return feed;
    }

    void stepAlone(FollowedRadii& radii, const FollowedFeed& feed) const override {
        doubleStroke(radii.fed_mm, strokeFeed(feed), [&](const Pass& pass) {
            if (pass.isStroke) {
                strokeAlone(radii, feed, pass);
            } else {
                for (FollowedRadius& radius : radii.radii) {
                    if (radius.zone == static_cast<std::size_t>(pass.zone)) {
                        cutAlone(radius, m_plungeBalances[radius.zone], pass.feed.at(radius.share));
                    }
                }
            }
            ++radii.passes;
            return true;
        });
    }

    void strokesAlone(FollowedRadii& radii, const FollowedFeed& feed) const override {
        if (feed.continuousFeed_mm_min > 0) {
            doubleStroke(radii.fed_mm, strokeFeed(feed), [&](const Pass& pass) {
                if (pass.isStroke) {
                    strokeAlone(radii, feed, pass);
                    ++radii.passes;
                }
                return true;
            });
            return;
        }
        const ReversalFeeds reversals = reversalsOf(feed.infeed_mm);
        for (const double infeed_mm : {reversals.entry_mm, reversals.exit_mm}) {
            radii.fed_mm += infeed_mm;
            for (FollowedRadius& radius : radii.radii) {
                cutAlone(radius, feed.strokes[radius.zone], radii.fed_mm);
            }
            ++radii.passes;
        }
    }

    bool hasStrokesAlone() const override { return false; }

private:
    static constexpr std::size_t zoneCount = 3;

    /// The zones' middles, followed by their sections if there are several.
    static std::vector<CompliantPoint> pointsOf(const Project& project,
                                                const std::stop_token& stop) {
        std::vector<CompliantPoint> points = compliantPoints(project, stop);
        const std::vector<CompliantPoint> sections = zoneSectionPoints(project, stop);
        for (CompliantPoint& middle : points) {
            middle.length_mm = sections.empty() ? middle.length_mm : 0; // counted by its sections
        }
        points.insert(points.end(), sections.begin(), sections.end());
        return points;
    }

    /// Computes the share of a stroke from the entry at which the wheel's middle is nearest to each
    /// section.
    void placeSections() {
        const Machine& machine = *m_project.machine;
        const double first_mm = m_project.wheel->width_mm / 2 - machine.overrun_entry_mm;
        for (const CompliantPoint& section : zoneSectionPoints(m_project)) {
            const double way_mm = fromEntry(m_project, section.position_mm) - first_mm;
            m_wayShares.push_back(std::clamp(way_mm / m_travel_mm, 0.0, 1.0));
        }
    }

    std::shared_ptr<const CutWidth> sharedCut(double width_mm) const {
        return std::make_shared<const CutWidth>(m_run.makeCut(width_mm));
    }

    const CutWidth& plungeCut(Zone zone) const {
        return zone == Zone::rz2 ? *m_plunge2 : *m_plunge1;
    }

    double strokeWidth(double axialFeed) const {
        return std::min(axialFeed / rpm(), m_project.wheel->width_mm);
    }

    ReversalFeeds reversalsOf(double infeed_mm) const {
        return reversalFeeds(m_project.machine->reversal_infeed, infeed_mm);
    }
    double rpm() const { return m_project.machine->work_speed_rpm; }
    double revolution_s() const { return units::secondsPerMinute / rpm(); }

    Place place(Zone zone, Step step, int revolution = 1) const {
        return {.zone = zone,
                .step = step,
                .section = static_cast<int>(zone),
                .stage = static_cast<int>(m_stage) + 1,
                .cycleCount = m_steps,
                .revolution = revolution};
    }

    /// The feed of a double stroke: S_t at the reversals and S_c continuously.
    struct StrokeFeed {
        double infeed_mm = 0;
        double perRevolution_mm = 0;                              ///< S_c/n
        double perStroke_mm = 0;                                  ///< S_c·travel/S_ax
        double most_mm = std::numeric_limits<double>::infinity(); ///< t_П at which S_c stops

        [[nodiscard]] bool drifts() const { return perStroke_mm > 0; }
        /// t_П after an amount of the continuous infeed.
        [[nodiscard]] double after(double fed, double drift) const {
            return drifts() ? std::max(fed, std::min(fed + drift, most_mm)) : fed;
        }
    };

    StrokeFeed strokeFeed(const StepFeed& step) const {
        StrokeFeed feed{.infeed_mm = step.infeed_mm};
        if (const double continuous = step.continuousFeed_mm_min; continuous > 0) {
            feed.perRevolution_mm = continuous / rpm();
            feed.perStroke_mm = continuous * m_travel_mm / step.axialFeed_mm_min;
            feed.most_mm = step.most_mm;
        }
        return feed;
    }

    StrokeFeed strokeFeed(const FollowedFeed& feed) const {
        return strokeFeed(StepFeed{.infeed_mm = feed.infeed_mm,
                                   .axialFeed_mm_min = feed.axialFeed_mm_min,
                                   .continuousFeed_mm_min = feed.continuousFeed_mm_min});
    }

    /// S_t + S_c·T.
    double programmed_mm(const StrokeFeed& feed) const {
        if (!feed.drifts()) {
            return feed.infeed_mm;
        }
        const ReversalFeeds reversals = reversalsOf(feed.infeed_mm);
        const int revolutions = plungeInRevolutions(*m_project.machine, reversals.entry_mm)
                                + plungeInRevolutions(*m_project.machine, reversals.exit_mm)
                                + 2 * m_entryDwell + m_exitDwell;
        return feed.infeed_mm + revolutions * feed.perRevolution_mm + 2 * feed.perStroke_mm;
    }

    /// A pass of a double stroke: of all zones in a stroke, otherwise of one zone.
    struct Pass {
        Zone zone = Zone::rz1;
        bool isStroke = false;
        std::array<Step, zoneCount> steps{}; ///< by zone in a stroke, otherwise only the first
        int revolution = 1;
        PassFeed feed;
        const StrokeFeed* drift = nullptr; ///< of a stroke with a continuous infeed
        bool there = true;                 ///< for a stroke: from the entry
    };

    /// Calls `pass` for the passes of a double stroke in order, until one returns false. `fed` is
    /// t_П, which grows meanwhile.
    template <class Do>
    bool doubleStroke(double& fed, const StrokeFeed& feed, const Do& pass) const {
        const auto dwell = [&](Zone zone, Step step, int revolutions) {
            for (int m = 1; m <= revolutions; ++m) {
                if (!pass(Pass{zone, false, {step}, m, drifting({.base = fed}, fed, feed)})) {
                    return false;
                }
                fed = feed.after(fed, feed.perRevolution_mm);
            }
            return true;
        };
        const auto stroke = [&](const std::array<Step, zoneCount>& steps, bool there) {
            const bool done = pass(Pass{
                Zone::rz1, true, steps, 1, {.base = fed}, feed.drifts() ? &feed : nullptr, there});
            fed = feed.after(fed, feed.perStroke_mm);
            return done;
        };
        const ReversalFeeds reversals = reversalsOf(feed.infeed_mm);
        // The continuous infeed may end before the exit.
        const auto left = [&](double infeed) {
            return feed.drifts() ? std::clamp(feed.most_mm - fed, 0.0, infeed) : infeed;
        };
        return plungeIn(Zone::rz1, Step::e1, fed, reversals.entry_mm, feed, pass)
               && dwell(Zone::rz1, Step::e2, m_entryDwell)
               && stroke({Step::e3, Step::e1, Step::e1}, true)
               && plungeIn(Zone::rz2, Step::e4, fed, left(reversals.exit_mm), feed, pass)
               && dwell(Zone::rz2, Step::e2, m_exitDwell)
               && stroke({Step::e4, Step::e2, Step::e3}, false)
               && dwell(Zone::rz1, Step::e5, m_entryDwell);
    }

    /// Adds the continuous infeed of a revolution, which does not end before `least`.
    static PassFeed drifting(PassFeed pass, double least, const StrokeFeed& feed) {
        if (feed.drifts()) {
            pass.drift = feed.perRevolution_mm;
            pass.most = std::max(feed.most_mm, least);
        }
        return pass;
    }

    /// The share of a stroke after which a zone is visited: when the wheel's middle is nearest to
    /// its own: in РЗ1 o1/2 from the wheel's reversal, in НЗ halfway, in РЗ2 o2/2 from the
    /// reversal, on the way there or back.
    [[nodiscard]] double wayShare(std::size_t zone, bool there) const {
        const Machine& machine = *m_project.machine;
        const std::array<double, zoneCount> way_mm{
            std::max(machine.overrun_entry_mm, 0.0) / 2, m_travel_mm / 2,
            m_travel_mm - std::max(machine.overrun_exit_mm, 0.0) / 2};
        const double share = way_mm[zone] / m_travel_mm;
        return there ? share : 1 - share;
    }

    /// t_П where the zones are visited.
    std::array<double, zoneCount> fedInStroke(double fed, const StrokeFeed& feed,
                                              bool there) const {
        std::array<double, zoneCount> fedAt{};
        for (std::size_t zone = 0; zone < zoneCount; ++zone) {
            fedAt[zone] = feed.after(fed, feed.perStroke_mm * wayShare(zone, there));
        }
        return fedAt;
    }

    void strokeAlone(FollowedRadii& radii, const FollowedFeed& feed, const Pass& pass) const {
        std::array<double, zoneCount> fed{};
        fed.fill(pass.feed.base);
        if (pass.drift) {
            fed = fedInStroke(pass.feed.base, *pass.drift, pass.there);
        }
        for (FollowedRadius& radius : radii.radii) {
            cutAlone(radius, feed.strokes[radius.zone], fed[radius.zone]);
        }
    }

    /// E1 of РЗ1 with S = S_1, E4 of РЗ2 with S = S_2, in ⌈n·S/S_rad⌉ revolutions:
    /// t_П + min(S, (S_rad/n)·(m − 1 + (k+1)/K)).
    template <class Do>
    bool plungeIn(Zone zone, Step step, double& fed, double infeed, const StrokeFeed& feed,
                  const Do& pass) const {
        const int revolutions = plungeInRevolutions(*m_project.machine, infeed);
        const double perRevolution = m_project.machine->plunge_feed_mm_min / rpm();
        for (int m = 1; m <= revolutions; ++m) {
            const double base = fed + feed.perRevolution_mm * (m - 1);
            const PassFeed ramp{base, perRevolution * (m - 1), perRevolution, infeed};
            if (!pass(Pass{zone, false, {step}, m, drifting(ramp, fed + infeed, feed)})) {
                return false;
            }
        }
        fed = feed.after(fed + infeed, feed.perRevolution_mm * revolutions);
        return true;
    }

    /// False, without a change, if the run must end.
    bool cut(const Pass& pass, double infeed) {
        if (pass.isStroke) {
            const double duration = m_travel_mm / m_axialFeed * units::secondsPerMinute;
            const std::array places{place(Zone::rz1, pass.steps[0]), place(Zone::nz, pass.steps[1]),
                                    place(Zone::rz2, pass.steps[2])};
            const Run::PassInfo info{
                .duration_s = duration, .axialFeed_mm_min = m_axialFeed, .radialFeed_mm = infeed};
            if (!visitsApart(pass)) {
                m_run.cut(0, zoneCount, *m_stroke, pass.feed, places.data(), info);
            } else {
                const auto fed = fedInStroke(pass.feed.base,
                                             pass.drift ? *pass.drift : StrokeFeed(), pass.there);
                for (std::size_t zone = 0; zone < zoneCount; ++zone) {
                    const double later_s = duration * wayShare(zone, pass.there);
                    m_run.cut(zone, 1, *m_stroke, m_run.withWave({.base = fed[zone]}, later_s),
                              &places[zone], info);
                }
            }
            if (m_inZone > 0) {
                for (std::size_t i = 0; i < m_places.size(); ++i) {
                    m_places[i] = places[i / m_inZone];
                }
                strokeOverSections(pass, info);
            }
            m_run.advance(duration, m_stage);
            return true;
        }
        if (m_run.mustEnd()) {
            return false;
        }
        const Place at = place(pass.zone, pass.steps[0], pass.revolution);
        const auto zone = static_cast<std::size_t>(pass.zone);
        const Run::PassInfo info{.duration_s = revolution_s(), .radialFeed_mm = infeed};
        const PassFeed feed = m_run.withWave(pass.feed);
        m_run.cut(zone, 1, plungeCut(pass.zone), feed, &at, info);
        if (m_inZone > 0) {
            const std::size_t first = zone * m_inZone;
            std::fill_n(m_places.begin() + static_cast<std::ptrdiff_t>(first), m_inZone, at);
            m_run.cut(zoneCount + first, m_inZone, plungeCut(pass.zone), feed, &m_places[first],
                      info);
        }
        m_run.advance(revolution_s(), m_stage);
        return true;
    }

    /// Whether the zones or sections of a stroke are visited at moments of their own.
    bool visitsApart(const Pass& pass) const { return pass.drift || m_run.printsWaves(); }

    /// Cuts the sections of zones with several sections in a stroke; requires their places.
    void strokeOverSections(const Pass& pass, const Run::PassInfo& info) {
        if (!visitsApart(pass)) {
            m_run.cut(zoneCount, m_places.size(), *m_stroke, pass.feed, m_places.data(), info);
            return;
        }
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const double share = pass.there ? m_wayShares[i] : 1 - m_wayShares[i];
            const double fed =
                pass.drift ? pass.drift->after(pass.feed.base, pass.drift->perStroke_mm * share)
                           : pass.feed.base;
            const PassFeed feed = m_run.withWave({.base = fed}, info.duration_s * share);
            m_run.cut(zoneCount + i, 1, *m_stroke, feed, &m_places[i], info);
        }
    }

    const Project& m_project;
    std::size_t m_inZone;            ///< number of sections, 0 if a zone is its middle
    std::vector<Place> m_places;     ///< places of the sections in a pass
    std::vector<double> m_wayShares; ///< shares of the sections
    std::shared_ptr<const CutWidth> m_plunge1, m_plunge2, m_stroke; ///< shared by copies
    std::array<LaneBalance, zoneCount> m_plungeBalances;
    int m_entryDwell, m_exitDwell;
    double m_travel_mm;
    double m_axialFeed = 0;
    std::size_t m_stage = 0; ///< stage of the cycle
};

SimulationResult simulateGauged(Zone gaugeZone, const Project& project, Trajectory* trajectory,
                                const std::stop_token& stop) {
    const std::unique_ptr<CycleSteps> steps = traverseSteps(project, gaugeZone, trajectory, stop);
    return runCycle(project, *steps);
}

} // namespace

std::unique_ptr<CycleSteps> traverseSteps(const Project& project, Zone gaugeZone,
                                          Trajectory* trajectory, const std::stop_token& stop) {
    return std::make_unique<TraverseSteps>(project, gaugeZone, trajectory, stop);
}

SimulationResult simulateTraverse(const Project& project, Trajectory* trajectory,
                                  const std::stop_token& stop) {
    return simulateGauged(Zone::nz, project, trajectory, stop);
}

SimulationResult simulateTraverseGaugedIn(Zone zone, const Project& project,
                                          const std::stop_token& stop) {
    return simulateGauged(zone, project, nullptr, stop);
}

double strokesAndDwells_s(const Project& project, double axialFeed_mm_min) {
    const Machine& machine = *project.machine;
    const double travel_mm = project.part->length_mm - project.wheel->width_mm
                             + machine.overrun_entry_mm + machine.overrun_exit_mm;
    const int dwells = 2 * dwellRevolutions(machine.dwell_entry_s, machine.work_speed_rpm)
                       + dwellRevolutions(machine.dwell_exit_s, machine.work_speed_rpm);
    return dwells * (units::secondsPerMinute / machine.work_speed_rpm)
           + 2 * travel_mm / axialFeed_mm_min * units::secondsPerMinute;
}

} // namespace sparkout
