// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/whole_batch.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

namespace sparkout {

/// A factor or a characteristic of a batch, by its number among the factors and then the
/// characteristics.
using BatchQuantity = std::size_t;

/// What the view of the batch draws, as values.
class BatchCharts {
    Q_DECLARE_TR_FUNCTIONS(BatchCharts)
public:
    enum Key { partsKey, sumKey, goodKey, outsideKey, worstKey, limitsKey }; ///< of the legends

    /// Why parts fail: a row a requirement, the most frequent at the top, with the share that the
    /// causes so far have of all. A part that fails several counts at each of them. No batch, or no
    /// part that fails: no series.
    static LineChart rejects(const BatchOutcomePtr& outcome);
    static CsvTable rejectsTable(const BatchSummary& summary);

    /// Any two quantities against each other: a point a part that is kept one by one, those beyond
    /// a limit of either and the worst part marked, with the limits.
    static LineChart scatter(const BatchOutcomePtr& outcome, BatchQuantity across,
                             BatchQuantity up);
    static QString quantityName(const BatchOutcome& outcome, BatchQuantity quantity);
};

} // namespace sparkout
