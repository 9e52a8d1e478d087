// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue_entry.h"
#include "core/issue.h"
#include "core/project/iso286.h"
#include "core/project/part.h"
#include "core/starting/starting_cycle.h"

#include <optional>
#include <string>

namespace sparkout {

/// What a drawing says of a surface to be ground.
struct StartingDrawing {
    std::string name;                   ///< of part and project
    std::optional<Operation> operation; ///< not given: plunge where the wheel covers the length
    Surface surface = Surface::external;
    double diameter_mm = 0;                              ///< d, nominal [mm]
    double upper_deviation_um = 0;                       ///< es, ES [µm]
    double lower_deviation_um = 0;                       ///< ei, EI [µm]
    double length_mm = 0;                                ///< L_p, ground length [mm]
    double stock_mm = 0;                                 ///< Π, per side [mm]
    double initial_runout_mm = Part().initial_runout_mm; ///< ΔR of the blank [mm]
    Tolerance tolerance;
    StartingEnds ends;
    /// Not given: a plain cylinder between centres that is ground on its whole length, or a bore
    /// with a quill that reaches through it.
    std::optional<Shaft> shaft;
};

/// The drawing's size: diameter, deviations, and of capital letters a bore. Nothing where the
/// standard has no such field.
[[nodiscard]] std::optional<StartingDrawing> drawingOf(const SizeDesignation& designation);

/// Names of the shipped catalogue, or parts of them; empty: usual ones.
struct StartingNames {
    std::string machine, wheel, material;
};

/// A machine, a wheel and a material.
struct StartingEntries {
    MachineEntry machine;
    WheelEntry wheel;
    MaterialEntry material;
};

/// The entries that are meant by the names; nothing, with what is known instead, where a name means
/// none or several. The usual ones are 3М151, for a bore 3К227; the first wheel of the catalogue,
/// for a bore the widest that goes into it; hardened 40Х.
[[nodiscard]] std::optional<StartingEntries>
startingEntries(const StartingNames& names, const StartingDrawing& drawing, Issues& issues);

/// The ends of a project's ground length: a thicker step of the shaft beside it is a shoulder, and
/// a blind bore has its wall at the headstock.
[[nodiscard]] StartingEnds startingEnds(const Project& project);

/// The project with a starting cycle for its part, wheel and machine as they are; unchanged where
/// they cannot be ground with one another, whatever the cycle is.
[[nodiscard]] Project withStartingCycle(Project project);

/// Whether the shaft is a plain cylinder, ground on its whole length, or the quill of a bore alone.
[[nodiscard]] bool hasPlainShaft(const Project& project);
/// The project with such a shaft for its diameter and length.
[[nodiscard]] Project withPlainShaft(Project project);

/// A starting cycle, or why there is none.
struct StartingAnswer {
    std::optional<StartingCycle> start; ///< with a valid project
    Issues issues;                      ///< errors, or warnings beside a project
};

/// A whole project for a drawing on a machine: part, shaft, material, wheel, machine as the entries
/// have them, gauge control, a starting cycle [MODEL-15] and a usual batch, whose numbers of
/// machine and gauge are the entry's. The wheel runs as fast as machine and wheel allow, where both
/// say it. Without a search.
[[nodiscard]] StartingAnswer startingProject(const StartingDrawing& drawing,
                                             const StartingEntries& entries);

} // namespace sparkout
