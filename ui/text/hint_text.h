// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <QString>

#include <vector>

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

// The help pages of the inputs, generated from their tables.

/// A row of the tables and the place of its description.
struct FieldPlace {
    const Field* field;
    const StructInfo* table; ///< table of the row
    Page page;               ///< page that shows it; none: only in the project file
    QString anchor;          ///< path, "part.diameter_mm"
};

/// All rows, in their order. A struct with several occurrences is described at the first.
[[nodiscard]] const std::vector<FieldPlace>& fieldPlaces();

/// "inputs-part" …, "inputs-file" for rows that no form shows.
[[nodiscard]] QString fieldPageId(Page page);
/// "inputs-part#part.diameter_mm"
[[nodiscard]] QString fieldTopic(const Field& field);

/// The rows of a page as HTML, in the current language.
[[nodiscard]] QString fieldsHtml(Page page);

} // namespace sparkout
