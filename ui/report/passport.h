// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/batch/judgement.h"
#include "core/measured/adequacy.h"
#include "ui/report/report_kinds.h"

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

/// The verdict on the cycle and its reason, for the accuracy passport.
class PassportVerdict {
    Q_DECLARE_TR_FUNCTIONS(PassportVerdict)
public:
    static Fitness fitness(const Subject& subject, const Judgement& judgement);
    static QString decision(const Subject& subject, const Judgement& judgement);
    static std::vector<Block> verdict(const Subject& subject);

    /// The deciding characteristic: that with the greatest share out of tolerance, otherwise with
    /// the least Ppk; null if none is limited.
    static const CharacteristicSummary* deciding(const BatchSummary& summary);
    static const CharacteristicSummary* leastCapable(const BatchSummary& summary);
};

/// The accuracy passport: the result of the cycle for a batch of parts compared with the drawing,
/// from the inputs and factors to the verdict, so that it can be reproduced. Without a batch it
/// covers only the nominal part, and states so.
[[nodiscard]] Report passport(const Subject& subject);

} // namespace sparkout::report
