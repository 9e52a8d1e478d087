// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <QString>

#include <string>

/// Texts and numbers for the cells of every document.
namespace sparkout::report {

/// A text of the user on one line, without characters that are invalid in documents.
[[nodiscard]] QString oneLine(const std::string& text);
/// A text over several lines.
[[nodiscard]] QString manyLines(QString text);
/// For a cell: never empty.
[[nodiscard]] QString cell(const QString& text);

/// A value and the unit of a table, not to be parted.
[[nodiscard]] QString withUnit(const QString& value, const char* unit);
/// The unit of a requirement in a table: that of a radial feed is the one in the stages' table.
[[nodiscard]] QString requirementUnit(ConstraintKind kind);

} // namespace sparkout::report
