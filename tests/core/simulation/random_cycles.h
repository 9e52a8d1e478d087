// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"
#include "core/process/system_compliance.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

/// Random cycles, small and varied, that shrink when a law fails, and what the laws of them share.
namespace sparkout::random_cycles {

using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::Law;
using fixtures::oneIn;
using fixtures::pick;
using fixtures::rounding;
using fixtures::Traced;
using fixtures::within;

/// The model's own accuracy of the elastic balance at a pass [mm] (MODEL-11).
constexpr double balance_mm = 1e-12;
/// A radius of up to 65 mm is rounded when it is made from a depth [mm].
constexpr double radiusRounding_mm = 64 * fixtures::epsilon;
/// Added to every threshold that ends a stage [mm] (MODEL-7).
constexpr double threshold_mm = 1e-9;

inline void anyBlank(Part& part) {
    part.radii_per_section = std::vector{4, 6, 8, 12, 36}[std::size_t(pick(0, 5))];
    part.stock_mm = between(0.01, 0.25);
    part.initial_runout_mm = oneIn(6) ? 0 : between(0, 0.06);
    part.profile = ProfileForm(pick(0, 4));
    part.lobes = pick(2, 8);
    if (part.profile == ProfileForm::measured) {
        part.radii_um.emplace();
        for (int k = 0; k < part.radii_per_section; ++k) {
            part.radii_um->push_back(between(-30, 0));
        }
    }
}

inline void anyForce(Project& p) {
    p.material->flow_stress_mpa = between(600, 2800);
    p.material->friction = between(0.1, 0.6);
    p.wheel->dullness = oneIn(4) ? 0 : between(0.005, 0.15);
    p.machine->wheel_speed_m_s = between(20, 50);
    p.machine->work_speed_rpm = between(60, 350);
}

/// One to three stages; `steps` of feed in all, more or less; now and then stocks that do not sum
/// up, position control, a spark-out by count at the end.
inline void anyStages(Project& p) {
    const int count = pick(1, 4);
    const int steps = pick(3, 40);
    for (int z = 0; z < count; ++z) {
        Stage stage;
        stage.stock_mm = p.part->stock_mm / count * (oneIn(8) ? between(0.2, 3) : 1);
        const double feed = stage.stock_mm * count / steps / (1 + z);
        if (p.operation == Operation::plunge) {
            stage.radial_feed_mm_min = feed * p.machine->work_speed_rpm;
        } else {
            stage.radial_feed_mm = feed;
            stage.axial_feed_mm_min =
                between(0.05, 1.1) * p.wheel->width_mm * p.machine->work_speed_rpm;
        }
        p.cycle->stages.push_back(stage);
    }
    if (oneIn(3)) {
        Stage last = p.cycle->stages.back();
        last.spark_out = fixtures::count(pick(1, 12));
        last.stock_mm = oneIn(2) ? 0 : 0.1 * p.part->stock_mm;
        p.cycle->stages.push_back(last);
    }
    p.gauge->rule = GaugeRule(pick(0, 3));
    p.gauge->control = oneIn(3) ? Control::position : Control::gauge;
}

inline Project anyContact(Operation operation) {
    Project p;
    p.operation = operation;
    p.part->surface = oneIn(3) ? Surface::internal : Surface::external;
    p.part->diameter_mm = between(25, 130);
    anyBlank(*p.part);
    anyForce(p);
    p.wheel->width_mm = between(15, 70);
    p.wheel->diameter_mm = p.part->surface == Surface::internal
                               ? between(0.3, 0.9) * p.part->diameter_mm
                               : between(250, 750);
    return p;
}

inline Project anyPlunge(int leastSections = 1) {
    Project p = anyContact(Operation::plunge);
    p.part->length_mm = between(0.3, 1) * p.wheel->width_mm;
    p.sections = pick(leastSections, 6);
    std::vector<double> gammas;
    for (int j = 0; j < p.sections; ++j) {
        gammas.push_back(decades(-6, -4));
    }
    p.machine->compliance_mm_per_n = gammas;
    p.gauge->section = pick(0, p.sections);
    anyStages(p);
    return p;
}

inline Project anyTraverse() {
    Project p = anyContact(Operation::traverse);
    p.machine->overrun_entry_mm = between(0, 0.7) * p.wheel->width_mm;
    p.machine->overrun_exit_mm = between(0, 0.7) * p.wheel->width_mm;
    p.part->length_mm = 2 * p.wheel->width_mm - p.machine->overrun_entry_mm
                        - p.machine->overrun_exit_mm + between(2, 100);
    p.machine->dwell_entry_s = oneIn(3) ? 0 : between(0.01, 0.6);
    p.machine->dwell_exit_s = oneIn(3) ? 0 : between(0.01, 0.6);
    p.machine->compliance_mm_per_n =
        ZoneCompliance{decades(-6, -3.7), decades(-6, -3.7), decades(-6, -3.7)};
    anyStages(p);
    p.machine->plunge_feed_mm_min = std::max(
        1e-3, p.machine->work_speed_rpm * *p.cycle->stages[0].radial_feed_mm / between(0.3, 6));
    return p;
}

inline Project anyCycle() {
    return oneIn(2) ? anyPlunge() : anyTraverse();
}

/// t_П at the end of the run; the largest of it rounds worst.
inline double programmed(const Traced& run) {
    return run.trajectory.visits.back().programmed_mm;
}

/// Calls check(pass, k, visit, depth of the radius before anything is cut) for every visit.
template <class Check>
void forEachVisit(const Traced& run, Check check) {
    const std::vector<double> depths = fixtures::blankDepths(run.result.project);
    for (const Pass& pass : run.trajectory.passes) {
        for (int k = 0; k < run.trajectory.radii; ++k) {
            check(pass, k, run.visit(pass, k), depths[std::size_t(k)]);
        }
    }
}

inline double gammaOf(const Traced& run, const Pass& pass) {
    return run.result.sections[std::size_t(pass.place.section)].compliance_mm_per_n;
}

/// What the gauge would read of these radii, less the target, per side (MODEL-7) [mm].
inline double remaining(const Project& p, const std::vector<double>& R) {
    const std::size_t half = R.size() / 2;
    std::vector<double> D;
    for (std::size_t k = 0; k < half; ++k) {
        D.push_back(R[k] + R[k + half]);
    }
    const double mean = std::accumulate(D.begin(), D.end(), 0.0) / double(half);
    const auto [low, high] = std::minmax_element(D.begin(), D.end());
    const bool internal = p.part->surface == Surface::internal;
    const double reading = p.gauge->rule == GaugeRule::mean                ? mean
                           : (p.gauge->rule == GaugeRule::min) != internal ? *low
                                                                           : *high;
    const double target = targetRadius(*p.part);
    return internal ? target - reading / 2 : reading / 2 - target;
}

template <class Check>
bool holds(const char* law, Check check) {
    return rc::check(law, check);
}

} // namespace sparkout::random_cycles
