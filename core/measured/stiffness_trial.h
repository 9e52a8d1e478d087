// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/number_table.h"
#include "core/project/machine.h"
#include "core/project/project.h"
#include "core/statistics/intervals.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Determines the stiffness of headstock, tailstock and wheel head from loads and deflections at a
/// few places along the shaft [MODEL-13].
namespace sparkout {

/// The indicator's reading.
enum class DeflectionOf {
    part,  ///< the part against the bed: headstock, tailstock and bending
    system ///< the part relative to the wheel head
};

enum class StiffnessUnit { headstock, tailstock, wheel_head, count_ };

enum class StiffnessTrialStatus {
    found,
    tooFewPlaces,  ///< fewer different places than unknown stiffnesses
    notMeasurable, ///< a bore, steady rests, or a place that is not on the shaft
    negative,      ///< a unit would be stiffer than rigid: the readings contradict the shaft
};

/// The relation of deflection and load at a place.
enum class LoadLine {
    straight, ///< proportional
    play,     ///< straight, but with a deflection at zero load
    bent,     ///< the stiffness changes with the load
    untested  ///< a single load, or too few readings
};

struct FoundStiffness {
    StiffnessUnit unit = StiffnessUnit::headstock;
    double n_um = 0;                    ///< [N/µm]; beyond the play, if there is any
    std::optional<Interval> interval95; ///< with more readings than unknowns; high may be infinite
};

struct StiffnessTrial {
    StiffnessTrialStatus status = StiffnessTrialStatus::tooFewPlaces;
    std::vector<FoundStiffness> found;
    std::vector<StiffnessUnit> negative; ///< units with a negative stiffness
    std::vector<double> residuals_um;    ///< of the readings in their order, measured less fitted
    double rms_um = 0;                   ///< √(Σr²/(readings − unknowns)); 0 without freedom
    std::size_t unknowns = 0;
    LoadLine line = LoadLine::untested;
    /// With that relation: of headstock and tailstock, in a chuck of the headstock alone.
    std::vector<double> play_um;
};

struct StiffnessRequest {
    std::vector<StiffnessReading> readings;
    DeflectionOf deflection = DeflectionOf::part;
    /// For `system`: found from three places or more, otherwise the project's value.
    bool findWheelHead = false;
};

/// Least squares of δ/P = 1/j_w + (1 − u)²/j_h + u²/j_t + B(x), u = x/L_s, B the bending of the
/// project's shaft, which is known: the model's γ(x), linear in the compliances [MODEL-6]. In a
/// chuck 1/j_h + B(x).
///
/// Readings at several loads are also fitted with play, adding (1 − u)·s_h + u·s_t, and with
/// compliances that change with the load, P² replacing P: the better of the two is reported if its
/// improvement exceeds chance at 99 % by Fisher's distribution, and play is then separate from the
/// stiffness.
[[nodiscard]] StiffnessTrial stiffnessFromTrial(const Project& project,
                                                const StiffnessRequest& request);

/// The project with the found stiffnesses, recorded as calibrated on these data; γ is then
/// computed. Returns the project unchanged if nothing was found.
[[nodiscard]] Project withStiffness(const Project& project, const StiffnessTrial& trial,
                                    const std::string& data, const std::string& date,
                                    std::size_t readings);

/// The best places for determining headstock, shaft and tailstock: near both ends of the shaft and
/// half way.
[[nodiscard]] std::array<double, 3> stiffnessPlaces_mm(const Project& project);

/// The load of a trial [N]: that of the deepest cut of the project's cycle, at least 50 N.
[[nodiscard]] double stiffnessLoad_n(const Project& project);

[[nodiscard]] const char* keyOf(StiffnessUnit unit);
/// The unit's stiffness in the machine.
[[nodiscard]] double Stiffness::*memberOf(StiffnessUnit unit);

} // namespace sparkout
