// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout::report {

/// Remarks of a document beside the numbers of a run, one per line.
class OutcomeRemarks {
    Q_DECLARE_TR_FUNCTIONS(OutcomeRemarks)
public:
    static QStringList estimates(const Outcome& outcome); ///< predictions that rest on estimates
    static QStringList remarks(const Outcome& outcome);   ///< on the shop's figures, and messages
};

} // namespace sparkout::report
