// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"
#include "core/project/project.h"
#include "core/quality/constraints.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Texts about an input whose value was found from measurements.
class CalibrationText {
    Q_DECLARE_TR_FUNCTIONS(CalibrationText)
public:
    /// "calibrated on trace.csv (n = 261)"
    static QString brief(const Calibration& calibration);
    /// The text for an input that has been changed since: "no longer the value calibrated on …".
    static QString changed(const Calibration& calibration);
    /// The one of the two texts that applies in a project.
    static QString state(const Project& project, const Calibration& calibration);
    /// The state, then value, interval and date, each on its own line.
    static QString details(const Project& project, const Calibration& calibration);
    static QString number(double value); ///< with the significant digits of a fit
    static QString interval(const Calibration& calibration); ///< empty: not given
    static QString unit(const Project& project, const Calibration& calibration);
    static QString date(const Calibration& calibration); ///< in the format of the language
};

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
