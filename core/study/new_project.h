// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/starting/starting_project.h"

#include <string>
#include <vector>

namespace sparkout {

/// A small complete cycle of each operation, to start from.
[[nodiscard]] Project newProject(Operation operation = {});

/// Paths of the numbers that a drawing has to give before anything can be computed.
[[nodiscard]] std::vector<std::string> drawingInputs();

/// A project for a drawing, startingProject(), with a usual search about its cycle.
[[nodiscard]] StartingAnswer drawnProject(const StartingDrawing& drawing,
                                          const StartingEntries& entries);

/// A starting cycle on the usual machine of the catalogue for a part that is yet to be drawn: no
/// requirement of form, no name, and in place of the drawing's numbers some that no drawing has, so
/// that giving one is always a change.
[[nodiscard]] Project undrawnProject(Operation operation);

/// In place of the limit deviations some that no drawing has, so that giving one is always a
/// change.
[[nodiscard]] Project withoutDeviations(Project project);

} // namespace sparkout
