// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/cycle_response.h"

#include "core/batch/characteristics.h"
#include "core/batch/worker_pool.h"
#include "core/phases/phase_decision.h"
#include "core/process/compliance.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/simulation/plunge.h"
#include "core/simulation/simulate.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

class Responder {
public:
    Responder(const Project& project, const CycleFactors& factors, bool withPlaces,
              const std::stop_token& stop)
        : m_scaled(scaledProject(project, factors))
        , m_law(forceLaw(project))
        , m_scaledLaw(forceLaw(m_scaled))
        , m_withPlaces(withPlaces)
        , m_isExternal(project.part->surface == Surface::external)
        , m_steps(m_scaled.operation->travels
                      ? traverseSteps(m_scaled, Zone::nz, &m_trajectory, stop)
                      : plungeSteps(m_scaled, &m_trajectory, stop)) {
        const double wheelSpeed_mm_s = project.machine->wheel_speed_m_s * units::mmPerM;
        m_kwPerN = wheelSpeed_mm_s / (units::mmPerM * units::wPerKw); // N·mm/s = mW
    }

    CycleResponse run(const std::vector<int>& stepsByStage) {
        const std::vector<double> feeds = infeedsOfStages(m_scaled);
        addSize();
        addIdle(0);
        bool ok = true;
        for (std::size_t z = 0; ok && z < stepsByStage.size() && z < feeds.size(); ++z) {
            for (int i = 0; ok && i < stepsByStage[z]; ++i) {
                ok = step(z, feedsIn(z) ? feeds[z] : 0, std::numeric_limits<double>::infinity());
            }
        }
        return finish(ok, stepsByStage);
    }

    /// Runs a cycle whose stages end by the wheel head's position.
    CycleResponse runByPosition() {
        StageControl control(m_scaled, infeedsOfStages(m_scaled),
                             m_steps->run().blank().totalInfeed_mm);
        addSize();
        addIdle(0);
        bool ok = true;
        while (ok && !control.finished() && !m_steps->run().mustEnd()) {
            ok =
                step(control.stage(), control.nextInfeed(m_steps->run().fed_mm), control.mostFed());
            control.stepDone(m_steps->remaining(), m_steps->run().fed_mm, m_steps->run().time_s());
        }
        return finish(ok && control.finished(), control.stepsByStage());
    }

private:
    [[nodiscard]] bool feedsIn(std::size_t stage) const {
        return m_scaled.cycle->stages[stage].feeds();
    }

    bool step(std::size_t stage, double infeed_mm, double most_mm) {
        Run& run = m_steps->run();
        const double before_s = run.time_s();
        const std::size_t firstPass = m_trajectory.passes.size();
        const Stage& settings = m_scaled.cycle->stages[stage];
        const bool done =
            !run.mustEnd()
            && m_steps->step({infeed_mm, stage, settings.axial_feed_mm_min.value_or(0),
                              m_scaled.operation->travels ? settings.continuousFeed_mm_min() : 0,
                              most_mm});
        m_response.middle_s.push_back((before_s + run.time_s()) / 2);
        addForces(firstPass);
        addSize();
        // Keeps only one step's visits, since a cycle may be long.
        m_trajectory.passes.clear();
        m_trajectory.visits.clear();
        return done;
    }

    /// Adds means over the passes of the step, weighted by their time, and over their radii.
    void addForces(std::size_t firstPass) {
        double chip = 0, friction = 0, time_s = 0;
        const auto radii = static_cast<std::size_t>(m_trajectory.radii);
        for (std::size_t i = firstPass; i < m_trajectory.passes.size(); ++i) {
            const Pass& pass = m_trajectory.passes[i];
            double depths = 0, roots = 0;
            std::size_t ground = 0;
            for (std::size_t k = 0; k < radii; ++k) {
                const Visit& visit = m_trajectory.visits[pass.firstVisit + k];
                if (!visit.isGap()) {
                    depths += visit.actual_mm;
                    roots += rubbingOf(visit, pass.effectiveWidth_mm);
                    ++ground;
                }
            }
            const double weight = pass.duration_s * pass.effectiveWidth_mm
                                  / static_cast<double>(std::max(ground, std::size_t{1}));
            chip += weight * depths;
            friction += weight * roots;
            time_s += pass.duration_s;
        }
        chip = time_s > 0 ? chip / time_s : 0;
        friction = time_s > 0 ? friction / time_s : 0;
        m_response.chip_n.push_back(m_law.ks * chip);
        m_response.friction_n.push_back(m_law.kr * friction);
        m_response.chip_kw.push_back(m_law.kt * chip * m_kwPerN);
        m_response.friction_kw.push_back(m_law.mu * m_law.kr * friction * m_kwPerN);
    }

    /// The factor of k_r: √a, or v with a threshold.
    [[nodiscard]] double rubbingOf(const Visit& visit, double width_mm) const {
        const double a = std::max(0.0, visit.actual_mm);
        if (!m_law.threshold) {
            return std::sqrt(a);
        }
        const ForceLaw& law = m_scaledLaw; // the law of the visit's force
        return a > 0 ? 1 : law.kr > 0 ? visit.normalForce_n / (width_mm * law.kr) : 0;
    }

    void addSize() {
        const Run& run = m_steps->run();
        const double sign = m_isExternal ? 2 : -2;
        m_response.end_s.push_back(run.time_s());
        m_response.size_mm.push_back(sign * m_steps->remaining());
        if (!m_withPlaces) {
            return;
        }
        const auto places = static_cast<std::size_t>(placeCount(m_scaled));
        m_response.placeSizes_mm.resize(places);
        for (std::size_t place = 0; place < places; ++place) {
            m_response.placeSizes_mm[place].push_back(sizeAt(place));
        }
    }

    /// D of a place less the target, by the gauge's rule.
    [[nodiscard]] double sizeAt(std::size_t place) const {
        const Part& part = *m_scaled.part;
        const auto [least, most] = m_steps->run().diameterDeviations(place);
        const double target = 2 * targetRadius(part) - part.diameter_mm;
        switch (m_scaled.gauge->rule) {
        case GaugeRule::min: return (m_isExternal ? least : most) - target;
        case GaugeRule::max: return (m_isExternal ? most : least) - target;
        case GaugeRule::mean: break;
        }
        return (least + most) / 2 - target;
    }

    /// Adds a step without a cut.
    void addIdle(double time_s) {
        m_response.middle_s.push_back(time_s);
        for (auto* const values : {&m_response.chip_n, &m_response.friction_n, &m_response.chip_kw,
                                   &m_response.friction_kw}) {
            values->push_back(0);
        }
    }

    CycleResponse finish(bool ok, const std::vector<int>& stepsByStage) {
        const double end_s = m_response.end_s.back();
        addIdle(end_s + (end_s - m_response.middle_s.back()));
        const SimulationResult result = m_steps->finish(stepsByStage);
        m_response.ran = ok;
        for (const SectionResult& section : result.sections) {
            const double mean_mm = meanOfGround(section.radii_mm);
            m_response.deviation_um.push_back((2 * mean_mm - m_scaled.part->diameter_mm)
                                              * units::umPerMm);
        }
        for (const auto* values : {&m_response.size_mm, &m_response.chip_n}) {
            for (const double value : *values) {
                m_response.ran = m_response.ran && std::isfinite(value);
            }
        }
        return std::move(m_response);
    }

    Project m_scaled;
    ForceLaw m_law;       ///< force law of the unchanged project
    ForceLaw m_scaledLaw; ///< force law of the run cycle
    bool m_withPlaces, m_isExternal;
    double m_kwPerN = 0;
    Trajectory m_trajectory;
    std::unique_ptr<CycleSteps> m_steps;
    CycleResponse m_response;
};

} // namespace

CycleFactors factorsOf(const Project& project) {
    CycleFactors factors;
    factors.blankRunout_mm = initialRunout(*project.part);
    return factors;
}

bool hasPlaceCompliances(const Project& project) {
    const bool isGiven =
        !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    return isGiven || (!project.sections_coupled && zoneSectionCount(project) == 0);
}

void scalePlaceCompliances(Project& project, const std::vector<double>& factors) {
    const std::vector<CompliantPoint> points = compliantPoints(project);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back(points[i].gamma_mm_n * (i < factors.size() ? factors[i] : 1));
    }
    if (project.operation->travels && values.size() == 3) {
        project.machine->compliance_mm_per_n = ZoneCompliance{values[0], values[1], values[2]};
    } else {
        project.machine->compliance_mm_per_n = std::move(values);
    }
}

// σ_i and α have the same effect on α, since γ precedes both: γ' = γ·c·σ·α. η then corrects β. The
// nonlinear wheel contact must deflect under P as before under σ·P.
Project scaledProject(const Project& project, const CycleFactors& factors) {
    Project scaled = project;
    scaled.runs.clear();
    scaled.measured.reset();
    if (hasThreshold(project)) {
        scaled.material->specific_force_mpa *= factors.alpha;
        scaled.material->threshold_force_n_mm *= factors.beta;
        scaleCompliance(scaled, factors.compliance);
        if (!factors.places.empty()) {
            scalePlaceCompliances(scaled, factors.places);
        }
        scaled.part->initial_runout_mm = factors.blankRunout_mm;
        return scaled;
    }
    scaleCompliance(scaled, factors.compliance * factors.flowStress * factors.alpha);
    if (auto& contact = scaled.machine->wheel_contact; contact && contact->n_um_at_n) {
        for (std::vector<double>& row : *contact->n_um_at_n) {
            row[0] /= factors.flowStress;
        }
    }
    if (!factors.places.empty()) {
        scalePlaceCompliances(scaled, factors.places);
    }
    setDullness(*scaled.wheel,
                dullnessOf(*scaled.wheel) * (factors.dullness * factors.beta / factors.alpha));
    scaled.part->initial_runout_mm = factors.blankRunout_mm;
    return scaled;
}

CycleResponse respond(const Project& project, const CycleFactors& factors,
                      const std::vector<int>& stepsByStage, bool withPlaces,
                      const std::stop_token& stop) {
    Responder responder(project, factors, withPlaces, stop);
    return project.gauge->control == Control::position ? responder.runByPosition()
                                                       : responder.run(stepsByStage);
}

std::vector<int> stepsByGauge(const Project& project, const CycleFactors& factors,
                              const std::stop_token& stop) {
    const SimulationResult result =
        simulateUnchecked(scaledProject(project, factors), nullptr, stop);
    return result.status == RunStatus::completed ? result.countsByStage : std::vector<int>();
}

namespace {

constexpr double hardlyLag_s = 1e-6;

// On a linear piece y(t) of slope r the reading is y − r·τ plus the decaying remainder of the
// difference at its beginning.
double laggedOnPiece(const std::vector<double>& times, const std::vector<double>& values,
                     std::size_t at, double reading, double over_s, double lag_s) {
    const double slope = (values[at + 1] - values[at]) / (times[at + 1] - times[at]);
    const double behind = slope * lag_s;
    return values[at] + slope * over_s - behind
           + (reading - values[at] + behind) * std::exp(-over_s / lag_s);
}

} // namespace

std::vector<double> laggedKnots(const std::vector<double>& times, const std::vector<double>& values,
                                double lag_s) {
    std::vector<double> knots = values;
    for (std::size_t i = 1; lag_s >= hardlyLag_s && i < times.size(); ++i) {
        knots[i] = times[i] > times[i - 1] ? laggedOnPiece(times, values, i - 1, knots[i - 1],
                                                           times[i] - times[i - 1], lag_s)
                                           : knots[i - 1];
    }
    return knots;
}

double laggedBetween(const std::vector<double>& times, const std::vector<double>& values,
                     const std::vector<double>& knots, double time, double lag_s) {
    if (lag_s < hardlyLag_s || times.size() < 2 || time <= times.front()) {
        return valueAt(times, values, time - std::min(lag_s, 0.0));
    }
    if (time >= times.back()) {
        return values.back()
               + (knots.back() - values.back()) * std::exp(-(time - times.back()) / lag_s);
    }
    const auto at =
        static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin())
        - 1;
    return laggedOnPiece(times, values, at, knots[at], time - times[at], lag_s);
}

double valueAt(const std::vector<double>& times, const std::vector<double>& values, double time) {
    if (times.empty() || time <= times.front()) {
        return values.empty() ? 0 : values.front();
    }
    if (time >= times.back()) {
        return values.back();
    }
    const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time)
                                                - times.begin());
    const double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
    return values[after - 1] + share * (values[after] - values[after - 1]);
}

SizesOverPhases sizesOverPhases(const Project& project, const CycleFactors& factors,
                                const std::stop_token& stop) {
    constexpr std::size_t stocks = 256;
    const StockRange range = usualPhases(project);
    const Project scaled = scaledProject(project, factors);
    std::vector<std::vector<double>> found(stocks);
    forEachIndex(workerCount(0), 0, static_cast<std::int64_t>(stocks), stop,
                 [&](std::size_t, std::int64_t index) {
                     Project part = scaled;
                     part.part->stock_mm = range.from_mm
                                           + (range.to_mm - range.from_mm)
                                                 * (static_cast<double>(index) + 0.5) / stocks;
                     const SimulationResult result = simulateUnchecked(part, nullptr, stop);
                     if (result.status == RunStatus::completed) {
                         for (const SectionResult& section : result.sections) {
                             found[static_cast<std::size_t>(index)].push_back(
                                 meanDeviation_um(section, part.part->diameter_mm));
                         }
                     }
                     return true;
                 });
    std::erase_if(found, [](const std::vector<double>& one) { return one.empty(); });
    SizesOverPhases sizes;
    const auto count = static_cast<double>(found.size());
    for (std::size_t i = 0; !found.empty() && i < found.front().size(); ++i) {
        double sum = 0, squares = 0;
        for (const std::vector<double>& one : found) {
            sum += one[i];
            squares += one[i] * one[i];
        }
        sizes.means_um.push_back(sum / count);
        sizes.deviations_um.push_back(
            std::sqrt(std::max(0.0, squares / count - sum / count * sum / count)));
    }
    return sizes;
}

} // namespace sparkout
