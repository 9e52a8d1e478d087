// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

/// Passes (PassFunction) for a force with a threshold [MODEL-2, MODEL-3], and with the wheel's
/// contact in series [MODEL-7]. Under a threshold a lane cuts, touches or is off:
///
///     a = (h − C)/A,  v = 1     where h > C,  C = γ·b·F'_0,  A = 1 + γ·b·K
///     a = 0,  v = h/C           where 0 < h ≤ C: the wheel presses with h/γ without cutting
///     a = 0,  v = 0             where h ≤ 0
///
/// The lanes keep v beside √a, see Lanes::keepRubbing().

namespace sparkout {

/// The state of a lane: the root u = √a [√mm] and the rubbing share v.
struct ThresholdState {
    double root = 0, rubbing = 0;
};

/// The state at a lag h [mm], with A4 = 4·A.
[[nodiscard]] ThresholdState thresholdState(double C, double A4, double h);

/// Puts a lane into a state and updates everything that a pass keeps of it.
void putState(Lanes& lanes, std::size_t lane, const ThresholdState& state);

/// Cuts the lanes of the range once; returns the largest √a [√mm].
double cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                        const PassRange& range);

/// Cuts the lanes with given states: C² is a, and C is v.
double cutAsGiven(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                  const PassRange& range);

/// The wheel's contact as a spring in series with the technological system, stiffer the harder it
/// is pressed; an option beyond the sources, off by default [MODEL-7, HASHIMOTO2020]. Under the
/// normal force P the wheel's surface deflects by
///
///     δ_c(P) = ∫₀^P dF/k(F)
///
/// with k(F) given at some forces, linear between them and constant before the first and after the
/// last; δ_c in closed form on each piece, ΔF/k₀·ln(1 + x)/x, x = (k₁ − k₀)/k₀·ΔF/(F₁ − F₀). The
/// elastic balance [MODEL-3] becomes
///
///     a + γ·P_y(a) + δ_c(P_y(a)) = h
///
/// whose left side rises strictly from 0 with a, so there is one root, between 0 and the root
/// without the contact.
class ContactCompliance {
public:
    /// Rows of [force N, stiffness N/µm], as the project file has them: at least one, forces ≥ 0
    /// and rising, stiffnesses > 0.
    explicit ContactCompliance(const std::vector<std::vector<double>>& n_um_at_n);

    /// δ_c(P) [mm], P ≥ 0 [N].
    [[nodiscard]] double deflection(double force_n) const;
    /// 1/k(P) [mm/N].
    [[nodiscard]] double compliance(double force_n) const;

    /// A pass (PassFunction) with the contact: cuts the lanes of the range once and returns the
    /// largest √a [√mm]. Each lane is solved by Newton's method in u = √a, within bounds, starting
    /// from the lane's last root.
    double cut(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
               const PassRange& range) const;

    /// The pass with a threshold of the force [MODEL-2]: finds the state of ThresholdState with A·a
    /// + C·v + δ_c(bks·a + bkr·v) = h.
    double cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients,
                            const PassFeed& feed, const PassRange& range) const;

    /// A·a + C·√a + δ_c(P) = h, P = bks·a + bkr·√a, for one lane; with a threshold v for √a.
    struct Balance {
        double A = 0, C = 0, bks = 0, bkr = 0;
    };
    /// The root √a, iterated from a guess; 0 where h ≤ 0.
    [[nodiscard]] double root(const Balance& balance, double h, double from) const;
    /// The state with a threshold.
    [[nodiscard]] ThresholdState state(const Balance& balance, double h) const;

private:
    struct Row {
        double force = 0;      ///< F [N]
        double stiffness = 0;  ///< k(F) [N/mm]
        double rise = 0;       ///< dk/dF up to the next row [1/mm]
        double deflection = 0; ///< δ_c(F) [mm]
    };

    [[nodiscard]] const Row& rowBefore(double force_n) const;

    std::vector<Row> m_rows; ///< the first at no force
};

/// The contact of a project's wheel; empty where it is rigid.
[[nodiscard]] std::optional<ContactCompliance> wheelContact(const Project& project);

} // namespace sparkout
