// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <cstddef>
#include <vector>

namespace sparkout::report {

/// A cylinder of the part's form, from the headstock end [mm].
struct OutlineStep {
    double from_mm = 0, to_mm = 0;
    double diameter_mm = 0;
};

/// A ground surface at its place.
struct GroundStep : OutlineStep {
    std::size_t surface = 0; ///< index into the set-up
    bool isBore = false;
};

/// The part of a set-up as drawn: its outer form with the ground diameters, its bores, and the
/// ground surfaces.
class PartOutline {
public:
    explicit PartOutline(const Setup& setup);

    [[nodiscard]] double length_mm() const { return m_length_mm; }
    [[nodiscard]] double largest_mm() const; ///< outer diameter
    /// The outer form from end to end; assumed where the inputs do not define it.
    [[nodiscard]] const std::vector<OutlineStep>& outer() const { return m_outer; }
    [[nodiscard]] bool isOuterKnown() const { return m_outerKnown; }
    [[nodiscard]] const std::vector<OutlineStep>& bores() const { return m_bores; }
    [[nodiscard]] const std::vector<GroundStep>& ground() const { return m_ground; } ///< by place

private:
    void addOuter(const Setup& setup);
    void addBores();

    double m_length_mm = 0;
    bool m_outerKnown = true;
    std::vector<OutlineStep> m_outer, m_bores;
    std::vector<GroundStep> m_ground;
};

} // namespace sparkout::report
