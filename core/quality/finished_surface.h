// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/ranges.h"
#include "core/quality/requirement.h"

#include <optional>
#include <utility>

namespace sparkout {

/// What can be said of the surface that a cycle leaves.
///
/// Where strips stay uncut, its size (diameters and radii), roundness, runouts, cylindricity,
/// taper, crown, form and roughness are known of the cut part alone: none of them is stated
/// anywhere. What is of passes or settings, as force, power, burn, time and the gauge's reading, is
/// stated still.
class FinishedSurface {
public:
    explicit FinishedSurface(const Project& project) : m_whole(!leavesStrips(project)) {}

    /// Else strips stay uncut.
    [[nodiscard]] bool isWhole() const { return m_whole; }
    /// Whether the value of a requirement can be stated.
    [[nodiscard]] bool tells(ConstraintKind kind) const {
        return m_whole || !requirementOf(kind).isOfSurface();
    }
    /// A quantity of the surface, where it can be stated.
    template <class Value>
    [[nodiscard]] std::optional<Value> stated(Value value) const {
        return m_whole ? std::optional<Value>(std::move(value)) : std::nullopt;
    }

private:
    bool m_whole;
};

} // namespace sparkout
