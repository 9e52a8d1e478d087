// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <QString>

/// What the window says of an input, all of it from its row.
namespace sparkout {

/// "Diameter d" as rich text: the symbol in italics, with its index below the line.
[[nodiscard]] QString labelMarkup(const Field& field);
/// With the symbol that it has in a project.
[[nodiscard]] QString labelMarkup(const Field& field, const Project& project);

/// The symbol alone; empty when there is none.
[[nodiscard]] QString symbolMarkup(const Field& field);

/// The head of a table's column as rich text: short label, symbol and unit.
[[nodiscard]] QString columnMarkup(const Field& field);
/// The same in plain words: "Radial feed, mm".
[[nodiscard]] QString columnText(const Field& field);

/// Meaning, formula, allowed and usual range, default, what empty means and the source of a field,
/// for its tooltip.
[[nodiscard]] QString hintMarkup(const Field& field);
/// The same for screen readers, a sentence each.
[[nodiscard]] QString hintPlain(const Field& field);
/// "Allowed 0.5…2000 mm, usual 5…1100 mm, default 36" as rich text; empty without limits.
[[nodiscard]] QString limitsMarkup(const Field& field);
/// The meaning alone, as rich text.
[[nodiscard]] QString meaningMarkup(const Field& field);

} // namespace sparkout
