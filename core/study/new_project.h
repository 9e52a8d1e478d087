// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/starting_project.h"

#include <string>
#include <vector>

namespace sparkout {

/// Returns a small complete project of an operation to start from.
[[nodiscard]] Project newProject(Operation operation = {});

/// Returns the paths of the numbers from the drawing that are needed before anything can be
/// computed.
[[nodiscard]] std::vector<std::string> drawingInputs();

/// Returns startingProject() for a drawing, with a usual search about its cycle and, as a warning,
/// wheelAdvice(); refused where the machine does not take part or wheel.
[[nodiscard]] StartingAnswer drawnProject(const StartingDrawing& drawing,
                                          const StartingEntries& entries);

/// Returns a starting cycle on the usual machine of the catalogue for a part whose drawing is still
/// to be entered: without a requirement of form and a name, and with numbers that no drawing has,
/// so that entering one is always a change.
[[nodiscard]] Project undrawnProject(Operation operation);

/// Returns the project with limit deviations that no drawing has, so that entering one is always a
/// change.
[[nodiscard]] Project withoutDeviations(Project project);

} // namespace sparkout
