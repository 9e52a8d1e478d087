// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <QString>

/// The texts of the window about an input, all of them from its row.
namespace sparkout {

/// "Diameter d" as rich text: the symbol in italics, with its index below the line.
[[nodiscard]] QString labelMarkup(const Field& field);
/// With the symbol for a project.
[[nodiscard]] QString labelMarkup(const Field& field, const Project& project);

/// The symbol alone; empty if there is none.
[[nodiscard]] QString symbolMarkup(const Field& field);

/// The heading of a column as rich text: short label, symbol and unit.
[[nodiscard]] QString columnMarkup(const Field& field);
/// The heading in plain text: "Radial feed, mm".
[[nodiscard]] QString columnText(const Field& field);

/// The tool tip of a field: meaning, formula, allowed and usual range, default, meaning of empty,
/// and source.
[[nodiscard]] QString hintMarkup(const Field& field);
/// The hint for screen readers, in sentences.
[[nodiscard]] QString hintPlain(const Field& field);
/// "Allowed 0.5…2000 mm, usual 5…1100 mm, default 36" as rich text; empty without limits.
[[nodiscard]] QString limitsMarkup(const Field& field);
/// Only the meaning, as rich text.
[[nodiscard]] QString meaningMarkup(const Field& field);

} // namespace sparkout
