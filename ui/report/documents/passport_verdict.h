// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/judgement/judgement.h"
#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

namespace sparkout::report {

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

} // namespace sparkout::report
