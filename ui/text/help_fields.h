// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>

#include <vector>

/// The help of the inputs, made from their tables.
namespace sparkout {

/// A row of the tables and where it is described.
struct FieldPlace {
    const Field* field;
    const StructInfo* table; ///< that it is a row of
    Page page;               ///< that shows it; none: it is in the project file only
    QString anchor;          ///< its path, "part.diameter_mm"
};

/// All rows, in their order. A struct that stands at several places is described at the first.
[[nodiscard]] const std::vector<FieldPlace>& fieldPlaces();

/// "inputs-part" …, "inputs-file" for what no form shows.
[[nodiscard]] QString fieldPageId(Page page);
/// "inputs-part#part.diameter_mm"
[[nodiscard]] QString fieldTopic(const Field& field);

/// The rows of a page as HTML, in the present language.
[[nodiscard]] QString fieldsHtml(Page page);

} // namespace sparkout
