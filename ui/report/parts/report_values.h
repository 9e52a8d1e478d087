// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/quality/constraints.h"
#include "ui/report/format/report.h"

#include <QString>

#include <string>
#include <utility>

/// Values and texts of the inputs, as every report writes them.
namespace sparkout::report {

/// A text of the user in one line, without signs that no document may hold.
[[nodiscard]] QString oneLine(const std::string& text);
/// The same over several lines.
[[nodiscard]] QString manyLines(QString text);
/// For a cell: never empty.
[[nodiscard]] QString cell(const QString& text);

/// An input's number with all its digits, as its form shows it.
[[nodiscard]] QString plainNumber(double value);
/// A value and the unit of a table, not to be parted.
[[nodiscard]] QString withUnit(const QString& value, const char* unit);
/// The unit of a requirement in a table: a radial feed's is that of the stages' table beside it.
[[nodiscard]] QString requirementUnit(ConstraintKind kind);
/// The ground size as a drawing writes it, in millimetres: "⌀30h6(−0.016)". The field is the one
/// whose limits these are, else the one in the part's name; a deviation of 0 is not written.
[[nodiscard]] QString drawnSize(const Part& part);
/// An input by its path: its name as in its form, with the symbol, and its value with the unit.
[[nodiscard]] std::pair<QString, QString> inputFact(const Project& project, const char* path);

/// A report of a project, still without blocks: who made what of which file when.
[[nodiscard]] Report begunReport(const QString& title, const Project& project, const QString& file,
                                 const QDate& date);

} // namespace sparkout::report
