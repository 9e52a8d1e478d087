// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

namespace sparkout::report {

/// What comes out of the cycle and its batch against the drawing, in the accuracy passport.
class PassportPrediction {
    Q_DECLARE_TR_FUNCTIONS(PassportPrediction)
public:
    static Table nominal(const Outcome& outcome); ///< of a passport without a batch
    static Table values(const Subject& subject);  ///< nominal, extremes, mean and s
    static Table capability(const BatchSummary& summary);
    static Table percentiles(const BatchSummary& summary);
    static std::vector<Block> worst(const Subject& subject);
    /// What the drawing and the process ask of one part, with margins and place.
    static Table requirements(const Outcome& outcome);
    static Table settings(const Outcome& outcome); ///< what is asked of the settings
};

} // namespace sparkout::report
