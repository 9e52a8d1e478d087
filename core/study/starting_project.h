// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"
#include "core/issue.h"
#include "core/project/iso286.h"
#include "core/project/part.h"
#include "core/study/starting_cycle.h"

#include <optional>
#include <string>

namespace sparkout {

/// The data of a drawing about a surface to be ground.
struct StartingDrawing {
    std::string name;                   ///< name of part and project
    std::optional<Operation> operation; ///< not given: plunge if the wheel covers the length
    Surface surface = Surface::external;
    double diameter_mm = 0;                              ///< d, nominal [mm]
    double upper_deviation_um = 0;                       ///< es, ES [µm]
    double lower_deviation_um = 0;                       ///< ei, EI [µm]
    double length_mm = 0;                                ///< L_p, ground length [mm]
    double stock_mm = 0;                                 ///< Π, per side [mm]
    double initial_runout_mm = Part().initial_runout_mm; ///< ΔR of the blank [mm]
    Tolerance tolerance;
    StartingEnds ends;
    /// Not given: a plain cylinder between centres, ground along its whole length, or a bore with a
    /// quill that reaches through it.
    std::optional<Shaft> shaft;
};

/// The drawing's size: diameter, deviations, and for capital letters a bore. Empty if the standard
/// does not have this field.
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

/// The entries with these names; if a name matches none or several, the known or these names
/// instead. The usual ones are 3М151, for a bore 3К227; usualWheel(); hardened 40Х.
[[nodiscard]] std::optional<StartingEntries>
startingEntries(const StartingNames& names, const StartingDrawing& drawing, Issues& issues);

/// The wheel of the shipped catalogue that a shop would take: for a bore the widest that fits,
/// otherwise the first of those that suit best. What counts is, in this order, whether it fits the
/// machine, whether it can grind the length, abrasive and hardness by the material, and grain by
/// the roughness of the work.
[[nodiscard]] const WheelEntry& usualWheel(const StartingDrawing& drawing, const Machine& machine,
                                           const Material& material);
/// The project with this wheel, as new.
[[nodiscard]] Project withUsualWheel(Project project);

/// A warning where the project's wheel usually leaves a greater Ra than required, also in a
/// starting cycle, while usualWheel() leaves it and fits the machine: it names that wheel. The
/// wheel is one for all surfaces of a part and therefore only advised.
[[nodiscard]] Issues wheelAdvice(const Project& project);

/// The faults that keep a new project from its machine: what of part and wheel does not fit, and
/// the machines of the shipped catalogue that take the part.
[[nodiscard]] Issues machineRefusals(const Project& project);

/// The ends of a project's ground length: a thicker step of the shaft beside it is a shoulder, and
/// a blind bore has its wall at the headstock.
[[nodiscard]] StartingEnds startingEnds(const Project& project);

/// A starting cycle for a project's part, wheel and machine; empty if no cycle can grind the part
/// with these.
[[nodiscard]] std::optional<StartingCycle> startingCycleOf(const Project& project);
/// The project with it, unchanged if there is none.
[[nodiscard]] Project withStartingCycle(Project project);

/// Whether the shaft is a plain cylinder, ground along its whole length, or only the quill of a
/// bore.
[[nodiscard]] bool hasPlainShaft(const Project& project);
/// The project with such a shaft for its diameter and length.
[[nodiscard]] Project withPlainShaft(Project project);

/// A starting cycle, or the reason why there is none.
struct StartingAnswer {
    std::optional<StartingCycle> start; ///< with a valid project
    Issues issues;                      ///< errors, or warnings with a project
};

/// A complete project for a drawing on a machine: part, shaft, material, wheel and machine by the
/// entries, gauge control, a starting cycle [MODEL-15] and a usual batch, with the entry's data of
/// machine and gauge. The wheel speed is the greatest that machine and wheel allow, if both give
/// it. Without a search.
[[nodiscard]] StartingAnswer startingProject(const StartingDrawing& drawing,
                                             const StartingEntries& entries);

} // namespace sparkout
