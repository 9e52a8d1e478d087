// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/wheel_wave.h"

#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

constexpr double turn_rad = 2 * std::numbers::pi, turn_deg = 360;

double angle_rad(double turns) {
    return turn_rad * (turns - std::floor(turns));
}

/// U·ω² of the wheel's unbalance [N].
double unbalanceForce_n(const WheelRunout& runout, double omega) {
    constexpr double kgM_per_gMm = 1e-6, mPerMm = 1e-3;
    const double U = runout.unbalance_g_mm ? *runout.unbalance_g_mm * kgM_per_gMm
                                           : runout.rotor_mass_kg.value_or(0)
                                                 * *runout.balance_grade_mm_s * mPerMm / omega;
    return U * omega * omega;
}

} // namespace

void WheelWave::prepare(Lanes& lanes, std::size_t radii) const {
    const std::size_t count = lanes.share.size();
    lanes.waveCos.resize(count);
    lanes.waveSin.assign(count, 0.0);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t k = lane % radii;
        lanes.waveCos[lane] =
            lane < radii ? std::cos(turn_rad * perTurn * lanes.share[lane]) : lanes.waveCos[k];
        lanes.waveSin[lane] =
            lane < radii ? std::sin(turn_rad * perTurn * lanes.share[lane]) : lanes.waveSin[k];
    }
}

double WheelWave::turnsOfWave(double turns) const {
    const double varied = swing > 0 ? swing * (1 - std::cos(turn_rad * turns / period)) : 0;
    return phase + perTurn * (turns + varied);
}

void WheelWave::put(double turns, PassFeed& feed, Lanes& lanes, std::size_t radii) const {
    if (!(swing > 0)) {
        const double alpha = angle_rad(turnsOfWave(turns));
        feed.waveCos_mm = amplitude_mm * std::cos(alpha);
        feed.waveSin_mm = -amplitude_mm * std::sin(alpha);
        return;
    }
    feed.waveCos_mm = amplitude_mm;
    feed.waveSin_mm = 0;
    for (std::size_t k = 0; k < radii; ++k) {
        lanes.waveCos[k] = std::cos(angle_rad(turnsOfWave(turns + lanes.share[k])));
    }
    for (std::size_t lane = radii; lane < lanes.waveCos.size(); lane += radii) {
        std::copy_n(lanes.waveCos.begin(), radii,
                    lanes.waveCos.begin() + static_cast<std::ptrdiff_t>(lane));
    }
}

double wholeTurns(double turns) {
    constexpr double rounding = 1e-6; // of a sum of times
    return std::max(std::ceil(turns - rounding), 0.0);
}

double wheelAmplitude_mm(const Project& project) {
    const std::optional<WheelRunout>& runout = project.wheel->runout;
    if (!runout) {
        return 0;
    }
    if (!runout->isForced()) {
        return runout->amplitude_um.value_or(0) / units::umPerMm;
    }
    const Machine& machine = *project.machine;
    const double turns_s = wheelSpeed_rpm(project) / units::secondsPerMinute;
    const double ratio =
        machine.wheel_head_frequency_hz ? turns_s / *machine.wheel_head_frequency_hz : 0;
    const double resonance = std::min(1 / std::abs(1 - ratio * ratio), mostResonance);
    return unbalanceForce_n(*runout, turn_rad * turns_s)
           / (machine.stiffness_n_um->wheel_head * units::umPerMm) * resonance;
}

std::optional<WheelWave> wheelWave(const Project& project) {
    if (!areWavesKnown(project)) {
        return std::nullopt;
    }
    const std::optional<WheelRunout>& runout = project.wheel->runout;
    const Machine& machine = *project.machine;
    const double workTurns_s = machine.work_speed_rpm / units::secondsPerMinute;
    // The round wheel leaves no wave of the length λ that is higher than λ²/(4·D_e).
    const Part& part = *project.part;
    const double length_mm = std::numbers::pi * part.diameter_mm / wavesPerTurn(project);
    const double De =
        equivalentDiameter(part.diameter_mm, project.wheel->diameter_mm, part.surface);
    WheelWave wave{.amplitude_mm =
                       std::min(wheelAmplitude_mm(project), length_mm * length_mm / (8 * De)),
                   .perTurn = wavesPerTurn(project),
                   .phase = runout->phase_deg / turn_deg};
    if (const auto& varied = machine.work_speed_variation) {
        constexpr double percent = 100;
        wave.period = workTurns_s * varied->period_s;
        wave.swing = varied->percent / percent * wave.period / turn_rad;
    }
    return wave;
}

} // namespace sparkout
