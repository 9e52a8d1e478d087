// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The inputs whose values were found from measurements.
class CalibratedTable {
    Q_DECLARE_TR_FUNCTIONS(CalibratedTable)
public:
    /// Input, value found, interval, unit, data, number, date, whether the project still has the
    /// value; no rows without calibrations.
    static Table of(const Project& project);
};

} // namespace sparkout::report
