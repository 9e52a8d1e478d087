// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <QString>

#include <string>

/// Texts and numbers as the cells of every document write them.
namespace sparkout::report {

/// A text of the user in one line, without signs that no document may hold.
[[nodiscard]] QString oneLine(const std::string& text);
/// The same over several lines.
[[nodiscard]] QString manyLines(QString text);
/// For a cell: never empty.
[[nodiscard]] QString cell(const QString& text);

/// A value and the unit of a table, not to be parted.
[[nodiscard]] QString withUnit(const QString& value, const char* unit);
/// The unit of a requirement in a table: a radial feed's is that of the stages' table beside it.
[[nodiscard]] QString requirementUnit(ConstraintKind kind);

} // namespace sparkout::report
