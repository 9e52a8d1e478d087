// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "ui/report/format/report.h"

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

/// The cycle card: the operator's settings and the predicted part, in the layout of an operation
/// card.
class CycleCard {
    Q_DECLARE_TR_FUNCTIONS(CycleCard)
public:
    /// Requires a valid run. `file` is the path of the project, or empty; `batch` belongs to the
    /// same inputs, and `predicting` to the measurements of the project; both may be null.
    [[nodiscard]] static Report write(const OutcomePtr& outcome, const QString& file,
                                      const QDate& date, const BatchOutcomePtr& batch = {},
                                      const BatchOutcomePtr& predicting = {});

    // Its sections.
    static std::vector<Block> verdict(const Outcome& outcome, const Judgement& judgement);
    static Table accuracy(const Outcome& outcome);  ///< by zone or section
    static Table zoneForms(const Outcome& outcome); ///< for zones with several sections
    static Table requirements(const Outcome& outcome);
};

} // namespace sparkout::report
