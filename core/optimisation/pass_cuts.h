// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/run.h"

#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// Tells in the middle of a cycle that it cannot hold a requirement on its passes. The nearness to
/// burning, the largest power and the largest depth only grow, so what is broken stays broken. Cut
/// is only what is broken by more than the means of judging are off; the rest is left to the
/// evaluation of the whole cycle. Where more than to hold is demanded, a power is broken beyond so
/// much less than its limit, a diameter within so much of the field's width of its ends: both only
/// come nearer to them.
class PassCuts {
public:
    explicit PassCuts(const Project& project);
    /// From now on a cycle must have so much of a relative margin, or may be cut.
    void demandMargin(double least);
    /// After a step of a stage, from 0.
    [[nodiscard]] std::optional<ConstraintKind> broken(const Run& run, std::size_t stage) const;

    /// At the end of a cycle: a diameter outside of the drawing's field, by more than rounding.
    /// What most cycles fail by, found without closing the books and judging all the rest.
    [[nodiscard]] std::optional<ConstraintKind> brokenAtEnd(const Run& run) const;
    /// Whether a deviation of a diameter [mm] is beyond the end of the field that cutting comes to.
    [[nodiscard]] bool isTooDeep(double deviation_mm) const { return left_mm(deviation_mm) < 0; }
    /// How much deeper than here a diameter of this deviation may yet be cut [mm].
    [[nodiscard]] double left_mm(double deviation_mm) const {
        return m_isBore ? m_most_mm - deviation_mm : deviation_mm - m_least_mm;
    }
    [[nodiscard]] ConstraintKind tooDeep() const {
        return m_isBore ? ConstraintKind::diameterMax : ConstraintKind::diameterMin;
    }

private:
    std::size_t m_points;         ///< whose diameters count
    double m_low_mm, m_high_mm;   ///< ends of the field
    double m_least_mm, m_most_mm; ///< of deviations
    bool m_isBore;
    std::vector<std::pair<ConstraintKind, PassBound>> m_bounds;
    std::vector<double> m_most; ///< of the bounds, for the margin demanded
};

} // namespace sparkout
