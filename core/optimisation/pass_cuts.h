// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/run.h"

#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// Cuts a cycle in the middle when its passes have broken a requirement. The nearness to burning,
/// the largest power and the largest depth only grow, so a broken requirement stays broken. A cycle
/// is cut only where the excess is greater than the error of the check; other cycles are left to
/// the evaluation after their end. Where a margin is demanded, a power is broken that far below its
/// limit, a diameter that share of the field's width from its ends: both only approach them.
class PassCuts {
public:
    explicit PassCuts(const Project& project);
    /// From now on a cycle with a smaller relative margin may be cut.
    void demandMargin(double least);
    /// Returns the requirement broken after a step of a stage, counted from 0.
    [[nodiscard]] std::optional<ConstraintKind> broken(const Run& run, std::size_t stage) const;

    /// Returns the requirement broken by a diameter at the end of a cycle, outside the drawing's
    /// field by more than rounding. Most cycles fail by it; it is found without computing and
    /// evaluating the whole result.
    [[nodiscard]] std::optional<ConstraintKind> brokenAtEnd(const Run& run) const;
    /// Returns whether a deviation of a diameter [mm] is beyond the end of the field that cutting
    /// approaches.
    [[nodiscard]] bool isTooDeep(double deviation_mm) const { return left_mm(deviation_mm) < 0; }
    /// Returns by how much a diameter of this deviation may still be reduced, in a bore enlarged
    /// [mm].
    [[nodiscard]] double left_mm(double deviation_mm) const {
        return m_isBore ? m_most_mm - deviation_mm : deviation_mm - m_least_mm;
    }
    [[nodiscard]] ConstraintKind tooDeep() const {
        return m_isBore ? ConstraintKind::diameterMax : ConstraintKind::diameterMin;
    }

private:
    std::size_t m_points;         ///< number of points whose diameters count
    double m_low_mm, m_high_mm;   ///< ends of the field
    double m_least_mm, m_most_mm; ///< ends of the deviations
    bool m_isBore;
    std::vector<std::pair<ConstraintKind, PassBound>> m_bounds;
    std::vector<double> m_most; ///< greatest values by bound, for the demanded margin
};

} // namespace sparkout
