// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/run.h"

#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// Cuts a cycle before its end when its passes have violated a requirement. The nearness to
/// burning, the largest power and the largest depth only grow, so a violation is final. A cycle is
/// cut only where the excess is greater than the error of the check; other cycles are left to the
/// evaluation after their end. Where a margin is demanded, the limit of a power is lower by it, and
/// that of a diameter lies within the tolerance by that share of its width: both only approach
/// them.
class PassCuts {
public:
    explicit PassCuts(const Project& project);
    /// Allows cutting cycles with a smaller relative margin from now on.
    void demandMargin(double least);
    /// Returns the requirement broken after a step of a stage, counted from 0.
    [[nodiscard]] std::optional<ConstraintKind> broken(const Run& run, std::size_t stage) const;

    /// Returns the requirement violated by a diameter at the end of a cycle, outside the drawing's
    /// tolerance by more than rounding. Most cycles fail by it; it is found without evaluating the
    /// whole result.
    [[nodiscard]] std::optional<ConstraintKind> brokenAtEnd(const Run& run) const;
    /// Returns whether a deviation of a diameter [mm] is beyond the end of the tolerance that
    /// cutting approaches.
    [[nodiscard]] bool isTooDeep(double deviation_mm) const { return left_mm(deviation_mm) < 0; }
    /// Returns the amount by which a diameter of this deviation may still be reduced, in a bore
    /// enlarged [mm].
    [[nodiscard]] double left_mm(double deviation_mm) const {
        return m_isBore ? m_most_mm - deviation_mm : deviation_mm - m_least_mm;
    }
    [[nodiscard]] ConstraintKind tooDeep() const {
        return m_isBore ? ConstraintKind::diameterMax : ConstraintKind::diameterMin;
    }

private:
    std::size_t m_points;         ///< number of points whose diameters count
    double m_low_mm, m_high_mm;   ///< ends of the tolerance
    double m_least_mm, m_most_mm; ///< ends of the deviations
    bool m_isBore;
    std::vector<std::pair<ConstraintKind, PassBound>> m_bounds;
    std::vector<double> m_most; ///< greatest values by bound, for the demanded margin
};

} // namespace sparkout
