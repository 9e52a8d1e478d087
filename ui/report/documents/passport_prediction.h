// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The predicted results of the cycle and its batch compared with the drawing, for the accuracy
/// passport.
class PassportPrediction {
    Q_DECLARE_TR_FUNCTIONS(PassportPrediction)
public:
    static Table nominal(const Outcome& outcome); ///< for a passport without a batch
    static Table values(const Subject& subject);  ///< nominal, extremes, mean and s
    static Table capability(const BatchSummary& summary);
    static Table percentiles(const BatchSummary& summary);
    static std::vector<Block> worst(const Subject& subject);
    /// The requirements of drawing and process on one part, with margins and places.
    static Table requirements(const Outcome& outcome);
    static Table settings(const Outcome& outcome); ///< requirements on the settings
};

} // namespace sparkout::report
