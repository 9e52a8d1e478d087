// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

#include <vector>

namespace sparkout::report {

/// Whether the model agrees with the parts that were measured, in the accuracy passport.
class PassportMeasured {
    Q_DECLARE_TR_FUNCTIONS(PassportMeasured)
public:
    /// Whether a project has measured parts to compare with a prediction.
    static bool applies(const Project& project);
    /// Empty without measured parts or a prediction.
    static std::vector<Block> blocks(const Subject& subject);
    /// The check of the calibration by unused traces; empty if there are none.
    static std::vector<Block> heldOut(const Project& project);

private:
    static Table table(const Project& project, const std::vector<AdequacyRow>& rows);
};

} // namespace sparkout::report
