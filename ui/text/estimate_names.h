// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Marks the values that rest on estimates.
class EstimateNames {
    Q_DECLARE_TR_FUNCTIONS(EstimateNames)
public:
    /// "flow stress, dullness, compliance", those that are not calibrated in the project; empty for
    /// a setting.
    static QString inputs(const Project& project, ConstraintKind kind);
    /// "Rests on estimates, to be calibrated: …"; empty if there are none.
    static QString behind(const Project& project, ConstraintKind kind);
};

} // namespace sparkout
