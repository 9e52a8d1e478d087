// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>

#include <vector>

/// The help pages of the inputs, generated from their tables.
namespace sparkout {

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
