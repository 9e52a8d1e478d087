// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"
#include "core/simulation/result.h"
#include "core/units.h"

#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// One setting of the machine compared with its adjustment range [MODEL-8], in the range's unit: mm
/// per double stroke, mm/min, mm/min, rev/min.
struct MachineRange {
    ConstraintKind kind;
    int stage = 0; ///< stage of the cycle, from 1; 0: the whole cycle
    double value = 0;
    double low = 0, high = 0, step = 0;
    double nearest = 0;  ///< the nearest value the machine can be set to
    bool onStep = false; ///< the value is on a step, to 1e-6 of it
};

/// Every feed and speed that the cycle sets and the machine limits, in the order of the kinds:
/// traverse S_t and S_ax of each stage, S_rad and S_c of each stage that has one; plunge S_p of
/// each stage; n. A stage that only sparks out sets no infeed. A kind restricts the result to it.
[[nodiscard]] std::vector<MachineRange> checkMachineRanges(const Project& project,
                                                           std::optional<ConstraintKind> only = {});

/// Stages compared with the commands of the gauge [MODEL-8].
struct GaugeCommands {
    int stages = 0;
    int commands = 0;
};

/// Empty where the wheel head's position ends the stages.
[[nodiscard]] std::optional<GaugeCommands> checkGaugeCommands(const Project& project);

/// Below this overlap B·n/S_ax the table advances more than the wheel's width in a revolution, and
/// strips between the turns stay uncut [MODEL-7].
inline constexpr double leastOverlap = 1;

/// The overlap of a stroke at an axial feed.
[[nodiscard]] double overlapOf(const Project& project, double axialFeed_mm_min);
/// Whether the overlap is at least the required one, up to rounding.
[[nodiscard]] constexpr bool holdsOverlap(double overlap, double least) {
    return overlap >= least * (1 - 1e-9);
}
/// Whether it leaves strips.
[[nodiscard]] constexpr bool leavesStrips(double overlap) {
    return !holdsOverlap(overlap, leastOverlap);
}

/// The overlap of one stage of a traverse cycle and its limit.
struct OverlapCheck {
    ConstraintKind kind = ConstraintKind::overlap; ///< the requirement with this limit
    int stage = 0;                                 ///< from 1
    double overlap = 0;
    double least = leastOverlap;
    [[nodiscard]] bool holds() const { return holdsOverlap(overlap, least); }
};

/// Checks a stroke in the last stage of a cycle or in another one. Where strips are left the limit
/// is 1, otherwise the greatest required one.
[[nodiscard]] OverlapCheck checkOverlap(const Project& project, double axialFeed_mm_min, bool last);
/// Checks each stage that has an axial feed; empty in plunge grinding.
[[nodiscard]] std::vector<OverlapCheck> checkOverlaps(const Project& project);

/// Whether a stage of the cycle leaves strips: then the computed size, form and roughness are those
/// of the cut surface alone.
[[nodiscard]] bool leavesStrips(const Project& project);

/// The number of double strokes or revolutions of a stage.
struct StageSteps {
    int stage = 0; ///< from 1
    int steps = 0;
};

/// The first of the stages with the fewest steps, of those that have stock and end by gauge or
/// position; the number of a counted spark-out is an input. Empty without such a stage.
[[nodiscard]] std::optional<StageSteps> fewestSteps(const SimulationResult& result);

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
    /// A length of the surface in micrometres.
    [[nodiscard]] std::optional<double> um(double value_mm) const {
        return stated(value_mm * units::umPerMm);
    }

private:
    bool m_whole;
};

} // namespace sparkout
