// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout::report {

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

} // namespace sparkout::report
