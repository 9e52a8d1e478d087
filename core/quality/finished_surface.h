// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/ranges.h"
#include "core/quality/requirement.h"

#include <optional>
#include <utility>

namespace sparkout {

/// The known values of the surface after a cycle.
///
/// Where strips stay uncut, its size (diameters and radii), roundness, runouts, cylindricity,
/// taper, crown, form and roughness are known for the cut part alone and are not reported. Values
/// of passes or settings, such as force, power, burn, time and the gauge's reading, are reported.
class FinishedSurface {
public:
    explicit FinishedSurface(const Project& project) : m_whole(!leavesStrips(project)) {}

    /// False: strips stay uncut.
    [[nodiscard]] bool isWhole() const { return m_whole; }
    /// Whether the value of a requirement can be stated.
    [[nodiscard]] bool tells(ConstraintKind kind) const {
        return m_whole || !requirementOf(kind).isOfSurface();
    }
    /// A value of the surface, if it is known.
    template <class Value>
    [[nodiscard]] std::optional<Value> stated(Value value) const {
        return m_whole ? std::optional<Value>(std::move(value)) : std::nullopt;
    }

private:
    bool m_whole;
};

} // namespace sparkout
