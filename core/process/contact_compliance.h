// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"
#include "core/process/threshold_pass.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

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
