// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout::report {

/// What a document states beside the numbers of a run, a line each.
class OutcomeRemarks {
    Q_DECLARE_TR_FUNCTIONS(OutcomeRemarks)
public:
    static QStringList estimates(const Outcome& outcome); ///< predictions that rest on estimates
    static QStringList remarks(const Outcome& outcome);   ///< of the shop's numbers, and messages
};

} // namespace sparkout::report
