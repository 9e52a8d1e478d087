// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/outcome.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The set-up of an operation as in every document: part, tooling, settings and stages.
class OperationSetup {
    Q_DECLARE_TR_FUNCTIONS(OperationSetup)
public:
    static QString operation(const Project& project); ///< its full name
    static Facts header(const Project& project, const QDate& date);
    static Facts settings(const Outcome& outcome); ///< speeds, dwells, overruns, tooling, gauge
    /// With the resulting counts, times, powers and forces, or with places to write them.
    static Table stages(const Outcome& outcome, bool results = true);
};

/// A report of a project, still without blocks: author, subject, file and date.
[[nodiscard]] Report begunReport(const QString& title, const Project& project, const QString& file,
                                 const QDate& date);

/// The inputs whose values were found from measurements.
class CalibratedTable {
    Q_DECLARE_TR_FUNCTIONS(CalibratedTable)
public:
    /// Input, value found, interval, unit, data, number, date, whether the project still has the
    /// value; no rows without calibrations.
    static Table of(const Project& project);
};

} // namespace sparkout::report
