// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"
#include "core/project/project.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// What is said of an input whose value was found from measurements.
class CalibrationText {
    Q_DECLARE_TR_FUNCTIONS(CalibrationText)
public:
    /// "calibrated on trace.csv (n = 261)"
    static QString brief(const Calibration& calibration);
    /// The same of an input that has another value by now: "no longer the value calibrated on …".
    static QString changed(const Calibration& calibration);
    /// Which of the two holds in a project.
    static QString state(const Project& project, const Calibration& calibration);
    /// The state, then value, interval and date, each in a line of its own.
    static QString details(const Project& project, const Calibration& calibration);
    static QString number(double value);                     ///< to the digits that a fit can tell
    static QString interval(const Calibration& calibration); ///< empty: not stated
    static QString unit(const Project& project, const Calibration& calibration);
    static QString date(const Calibration& calibration); ///< as the language writes it
};

} // namespace sparkout
