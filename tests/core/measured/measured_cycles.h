// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/cycle_response.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/simulation/simulate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "tests/core/support/project_samples.h"
#include "tests/whole_project.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/// Traces as they would be recorded of a plunge cycle, made from the visits of a run: another way
/// than that of the fit.
namespace sparkout::measured_cycles {

/// A plunge on a yielding shaft with two feeds, so that the deflection shows.
inline Project yieldingPlunge(int sections = 1) {
    Project project = samples::project("smallest-plunge");
    project.sections = sections;
    project.machine->compliance_mm_per_n =
        std::vector<double>(static_cast<std::size_t>(sections), 5e-4);
    project.part->stock_mm = 0.3;
    project.part->radii_per_section = 12;
    project.wheel->dullness = 0.01;
    project.gauge->rule = GaugeRule::mean;
    Stage rough = project.cycle->stages.front(), fine = rough;
    rough.radial_feed_mm_min = 2.0;
    rough.stock_mm = 0.22;
    fine.radial_feed_mm_min = 0.4;
    fine.stock_mm = 0.08;
    project.cycle->stages = {rough, fine};
    return project;
}

/// Size, power and force after each revolution.
struct Record {
    std::vector<double> end_s{0}, size_mm; ///< the first before the cycle
    std::vector<double> middle_s, power_kw, force_n;
};

inline double sizeOf(const Project& project, const std::vector<double>& radii_mm) {
    const std::size_t half = radii_mm.size() / 2;
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
    for (std::size_t k = 0; k < half; ++k) {
        const double d = radii_mm[k] + radii_mm[k + half];
        least = std::min(least, d);
        most = std::max(most, d);
        sum += d;
    }
    const GaugeRule rule = project.gauge->rule;
    const double size = rule == GaugeRule::min   ? least
                        : rule == GaugeRule::max ? most
                                                 : sum / static_cast<double>(half);
    return size - 2 * targetRadius(*project.part);
}

/// Of a plunge cycle with one gauged section (`gauged`, from 0).
inline Record record(const Project& project, std::size_t gauged = 0) {
    Trajectory trajectory;
    (void)simulate(project, &trajectory);
    const ForceLaw law = forceLaw(project);
    const double speed_m_s = project.machine->wheel_speed_m_s;
    const auto radii = static_cast<std::size_t>(trajectory.radii);
    const auto sections = static_cast<std::size_t>(project.sections);
    Record record;
    const Blank blank = makeBlank(*project.part);
    std::vector<double> profile;
    for (const double depth : blank.depth_mm) {
        profile.push_back(blank.firstTouchRadius_mm - depth);
    }
    record.size_mm.push_back(sizeOf(project, profile));
    for (std::size_t p = 0; p + sections <= trajectory.passes.size(); p += sections) {
        double power_w = 0, force_n = 0;
        for (std::size_t j = 0; j < sections; ++j) {
            const Pass& pass = trajectory.passes[p + j];
            for (std::size_t k = 0; k < radii; ++k) {
                const Visit& visit = trajectory.visits[pass.firstVisit + k];
                const double root = std::sqrt(std::max(0.0, visit.actual_mm));
                const double b = pass.effectiveWidth_mm, P = visit.normalForce_n;
                if (law.threshold) { // P_z = b·K_z·a + μ·min(P_y, b·F'_0)
                    power_w += (b * law.kt * visit.actual_mm + law.mu * std::min(P, b * law.kr))
                               * speed_m_s;
                    force_n += P;
                } else {
                    power_w += law.tangential(b, root) * speed_m_s;
                    force_n += law.normal(b, root);
                }
                if (j == gauged) {
                    profile[k] = visit.radius_mm;
                }
            }
        }
        const Pass& pass = trajectory.passes[p];
        const double count = static_cast<double>(radii * sections);
        record.end_s.push_back(pass.start_s + pass.duration_s);
        record.size_mm.push_back(sizeOf(project, profile));
        record.middle_s.push_back(pass.start_s + pass.duration_s / 2);
        record.power_kw.push_back(power_w / count / 1000);
        record.force_n.push_back(force_n / count);
    }
    // Half a revolution until the wheel is in full contact or out of it.
    const double end_s = record.end_s.back();
    record.middle_s.insert(record.middle_s.begin(), 0);
    record.middle_s.push_back(2 * end_s - record.middle_s.back());
    for (auto* const values : {&record.power_kw, &record.force_n}) {
        values->insert(values->begin(), 0);
        values->push_back(0);
    }
    return record;
}

inline double between(const std::vector<double>& times, const std::vector<double>& values,
                      double time) {
    if (time <= times.front()) {
        return values.front();
    }
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (time <= times[i]) {
            const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
            return values[i - 1] + share * (values[i] - values[i - 1]);
        }
    }
    return values.back();
}

/// The reading of a first-order lag, at rest at the first value.
inline double laggedAt(const std::vector<double>& times, const std::vector<double>& values,
                       double time, double lag_s) {
    return laggedBetween(times, values, laggedKnots(times, values, lag_s), time, lag_s);
}

/// How a trace is recorded.
struct Recording {
    double hertz = 10;
    double from_s = 0, to_s = 0; ///< to_s 0: the end of the cycle
    double noise = 0;            ///< standard deviation
    double quantum = 0;          ///< 0: none
    double offset = 0;           ///< added to the values
    double shift_s = 0;          ///< time of the trace at which the cycle begins
    std::uint32_t seed = 1;
};

inline MeasuredTrace trace(TraceQuantity quantity, const Record& cycle, const Recording& how) {
    const bool isSize = quantity == TraceQuantity::gauge_size;
    const std::vector<double>& at = isSize ? cycle.end_s : cycle.middle_s;
    const std::vector<double>& of = isSize                                    ? cycle.size_mm
                                    : quantity == TraceQuantity::normal_force ? cycle.force_n
                                                                              : cycle.power_kw;
    const double end_s = how.to_s > 0 ? how.to_s : cycle.end_s.back() + how.shift_s;
    std::vector<double> times, values;
    const auto samples = static_cast<std::uint64_t>((end_s - how.from_s) * how.hertz);
    for (std::uint64_t i = 0; i <= samples; ++i) {
        const double time = how.from_s + static_cast<double>(i) / how.hertz;
        const double inCycle = time - how.shift_s;
        double value = how.offset + between(at, of, inCycle);
        value += how.noise
                 * normalQuantile(openUnit(randomBits(how.seed, RandomStream::plain, i,
                                                      static_cast<std::uint32_t>(quantity))));
        if (how.quantum > 0) {
            value = std::round(value / how.quantum) * how.quantum;
        }
        times.push_back(time);
        values.push_back(value);
    }
    MeasuredTrace made;
    made.quantity = quantity;
    made.time_s = Samples(std::move(times));
    made.values = Samples(std::move(values));
    made.source = "test.csv";
    return made;
}

} // namespace sparkout::measured_cycles
