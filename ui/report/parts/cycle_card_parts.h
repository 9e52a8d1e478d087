// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

/// The parts of the cycle card.
namespace sparkout::report {

class CycleCard {
    Q_DECLARE_TR_FUNCTIONS(CycleCard)
public:
    static QString operation(const Project& project); ///< its full name
    static Facts header(const Project& project, const QDate& date);
    static Facts settings(const Outcome& outcome); ///< speeds, dwells, overruns, tooling, gauge
    static Table stages(const Outcome& outcome);
    static Table accuracy(const Outcome& outcome); ///< by zone or section
    static Table requirements(const Outcome& outcome);
    static std::vector<Block> verdict(const Outcome& outcome);
    static QStringList estimates(const Outcome& outcome);
    static QStringList remarks(const Outcome& outcome);
};

} // namespace sparkout::report
