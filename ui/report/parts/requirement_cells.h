// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout::report {

/// Value, margin and verdict of a requirement as a document states them. A roughness that no
/// measured one has been put in relation to is an estimate: a range, no margin, and it says so
/// where its limit lies within.
class RequirementCells {
    Q_DECLARE_TR_FUNCTIONS(RequirementCells)
public:
    explicit RequirementCells(const ConstraintResult& constraint);

    [[nodiscard]] QString value() const;
    [[nodiscard]] QString margin() const;
    [[nodiscard]] QString verdict() const;

    /// "Ra, µm" of a column, with what is to be known of its values.
    static QString roughnessHead(const Project& project);

private:
    const ConstraintResult& m_constraint;
};

} // namespace sparkout::report
