// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/whole_batch.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

namespace sparkout {

/// What the view of the batch draws, as values.
class BatchCharts {
    Q_DECLARE_TR_FUNCTIONS(BatchCharts)
public:
    enum Key { partsKey, sumKey, outsideKey, worstKey, limitsKey }; ///< of the legends

    /// Why parts fail: a row a requirement, the most frequent at the top, with the share that the
    /// causes so far have of all. A part that fails several counts at each of them. No batch, or no
    /// part that fails: no series.
    static LineChart rejects(const BatchOutcomePtr& outcome);
    static CsvTable rejectsTable(const BatchSummary& summary);
};

} // namespace sparkout
