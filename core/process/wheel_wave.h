// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"
#include "core/project/project.h"

#include <optional>

/// The wave that a wheel out of true prints onto the work [MODEL-16]: its surface stands
///
///     w = e·cos ψ,    ψ = ψ_0 + 2π·∫L·n_k dt
///
/// nearer to the work than t_П, at the time of the visit of a radius. In turns of the work θ since
/// the cycle began, with ρ = L·n_k/n, N = n·T and σ = s·N/2π,
///
///     ψ/2π = ψ_0/2π + ρ·(θ + σ·(1 − cos(2π·θ/N)))
///
/// where a pass begins with whole turns and visits radius k at θ = q + (k + 1)/K. A speed that
/// varies by ± s is n/(1 + s·sin(2π·θ/N)), so that the time of θ is known without solving for it.
namespace sparkout {

struct WheelWave {
    double amplitude_mm = 0; ///< e, at most λ²/(8·D_e)
    double perTurn = 0;      ///< ρ, waves of the wheel in one turn of the work
    double phase = 0;        ///< ψ_0/2π
    double swing = 0;        ///< σ; 0: the work speed is constant
    double period = 1;       ///< N

    /// Gives the lanes, K to a zone or section, what ψ advances within a pass.
    void prepare(Lanes& lanes, std::size_t radii) const;
    /// Adds the wave to the feed of a pass that begins after this number of turns of the work, and
    /// with a varied work speed to the lanes.
    void put(double turns, PassFeed& feed, Lanes& lanes, std::size_t radii) const;

    /// ψ/2π after this number of turns of the work.
    [[nodiscard]] double turnsOfWave(double turns) const;
};

/// The number of whole turns after which a pass begins that is due after `turns`.
[[nodiscard]] double wholeTurns(double turns);

/// The wave of the project's wheel; empty where its runout is not given, and so not known, and
/// where the radii do not resolve it: it would be read as one of another order.
[[nodiscard]] std::optional<WheelWave> wheelWave(const Project& project);

/// e of the wheel's runout, or what its unbalance makes of the wheel head's stiffness [mm]; 0 if it
/// is not given.
[[nodiscard]] double wheelAmplitude_mm(const Project& project);

/// Greatest factor by which an unbalance moves the wheel head near its natural frequency: that of a
/// damping ratio of 0.05, an estimate.
inline constexpr double mostResonance = 10;

} // namespace sparkout
