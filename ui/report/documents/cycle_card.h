// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/judged_outcome.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The cycle card: what the operator sets and what the part comes out as, in the layout of an
/// operation card.
class CycleCard {
    Q_DECLARE_TR_FUNCTIONS(CycleCard)
public:
    /// Of an outcome that ran. `file` is the path of the project, or empty; `batch` is of the same
    /// inputs, or null.
    [[nodiscard]] static Report write(const OutcomePtr& outcome, const QString& file,
                                      const QDate& date, const BatchOutcomePtr& batch = {});

    // Its sections.
    static std::vector<Block> verdict(const Outcome& outcome, const Judgement& judgement);
    static Table accuracy(const Outcome& outcome);  ///< by zone or section
    static Table zoneForms(const Outcome& outcome); ///< of zones that hold several sections
    static Table requirements(const Outcome& outcome);
};

} // namespace sparkout::report
