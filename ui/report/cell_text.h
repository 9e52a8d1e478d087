// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/quality/constraints.h"

#include <QCoreApplication>
#include <QString>

#include <string>
#include <utility>

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

/// Value, margin and verdict of a requirement in documents. A roughness without a measured
/// reference is an estimate: a range without a margin, marked if its limit is within it.
class RequirementCells {
    Q_DECLARE_TR_FUNCTIONS(RequirementCells)
public:
    explicit RequirementCells(const ConstraintResult& constraint);

    [[nodiscard]] QString value() const;
    [[nodiscard]] QString margin() const;
    [[nodiscard]] QString verdict() const;

    /// "Ra, µm" as the heading of a column, with remarks on its values.
    static QString roughnessHead(const Project& project);

private:
    const ConstraintResult& m_constraint;
};

/// The ground size as on a drawing, in millimetres: "⌀30h6(−0.016)". The tolerance field is the one
/// with these limits, otherwise the one in the part's name; a deviation of 0 is not written.
[[nodiscard]] QString drawnSize(const Part& part);
/// An input by its path: its name in the form, with the symbol, and its value with the unit.
[[nodiscard]] std::pair<QString, QString> inputFact(const Project& project, const char* path);

} // namespace sparkout::report
