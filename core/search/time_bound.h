// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/grid.h"

#include <vector>

namespace sparkout {

/// Least time that a cycle of a grid takes from a state to its end.
///
/// The gauge ends the cycle when Π_rem ≤ 0, up to the control's slack of 1 nm. Π_rem is |R_first −
/// R_t| = Π + ΔR less a mean of depths (of two opposite radii, or of all). A depth starts at ΔR or
/// less and is cut to no more than the programmed infeed (a ≤ h = t_П − depth), so a mean beyond ΔR
/// needs that infeed. With the stock L < Π of the later stages, as all in the grid have, the end of
/// a stage satisfies
///
///     t_П ≥ |R_first − R_t| − L − slack,
///
/// and under position control this is its end. A step of infeed x takes at least c(v) + x/S_rad in
/// traverse (c: dwells and both strokes at the axial feed v; N_E1 ≥ n·x/S_rad), 1/n in plunge.
/// Hence a stage's step of infeed x ≤ f takes at least x·r, r = c(v)/f + 1/S_rad (plunge: 1/(n·f)):
/// the infeed of a stage with the feed f takes at least r per mm, and that of the later stages,
/// whatever they are, at least the least r of the settings that may follow. A running stage must
/// feed at least up to its nearest end at its own r. The last stage, whose feed is known, must make
/// all of the steps ⌈infeed/f⌉ (under position control the last one may be short).
///
/// A stage with a continuous infeed S_c feeds nothing at the reversals: a double stroke takes c(v),
/// feeds at most x = f = S_c·c(v), and r = c(v)/f.
///
/// Where the gauge's zone or section has a stock Π_g of its own below Π, a stage with more left
/// than that ends at once: for the bound the infeed there is taken to be Π_g at most.
///
/// A cycle with a spark-out feeds only up to the stock L' of that stage, which is no greater than
/// the greatest that the grid allows a last stage and than the remaining stock: t_П ≥ |R_first −
/// R_t| − L' − slack at the end of the last feed. Then its N steps follow, each of at least c(v)
/// (plunge: 1/n).
///
/// Where the gauge ends the cycle with a delay, the delay follows the reading of the size, which
/// comes after all the remaining infeed.
class TimeBound {
public:
    TimeBound(const Project& project, const Grid& grid, double totalInfeed_mm);

    /// Returns the infeed of a step of the setting [mm].
    [[nodiscard]] double infeed_mm(std::size_t setting) const { return m_rates[setting].infeed_mm; }
    /// Returns the least time [s] from t_П = `fed_mm` to the end of the cycle, in a stage of the
    /// setting that does not end before the remaining stock is `later_mm`; `last`: it is the last
    /// stage. Returns 0 for a spark-out, whose beginning is not known here.
    [[nodiscard]] double rest_s(std::size_t setting, double fed_mm, double later_mm,
                                bool last) const;
    /// Returns the time [s] of a full step of the setting.
    [[nodiscard]] double step_s(std::size_t setting) const { return m_rates[setting].step_s; }
    /// Returns the time [s] of a spark-out with the setting.
    [[nodiscard]] double sparkOut_s(std::size_t setting) const {
        return m_rates[setting].sparkOut_s;
    }

private:
    void readSparkOuts(const Grid& grid);

    struct Rate {
        double infeed_mm = 0;     ///< f
        double fixed_s = 0;       ///< time of a step for any infeed
        double step_s = 0;        ///< time of a full step
        double s_per_mm = 0;      ///< r
        double next_s_per_mm = 0; ///< least r of the setting itself and of those that may follow
        double sparkOut_s = 0;    ///< time of a spark-out setting
    };
    std::vector<Rate> m_rates;
    double m_total;
    double m_mostLast_mm = 0; ///< greatest L'
    double m_sparkOut_s = 0;  ///< the least of the grid's spark-outs
    double m_delay_s = 0;     ///< time from the size to the end of the cycle
    bool m_shortLastStep;
};

/// Returns the infeed of a step with a setting [mm]: its radial feed, or S_c during a double
/// stroke.
[[nodiscard]] double infeedOf(const Project& project, const StageSetting& setting);

/// Returns the least time of all cycles of a grid [s].
[[nodiscard]] double leastTime_s(const Project& project, const Grid& grid);

} // namespace sparkout
