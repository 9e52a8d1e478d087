// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/whole_batch.h"
#include "ui/chart/line_chart.h"

#include <QCoreApplication>

#include <string>

namespace sparkout {

/// A factor or a characteristic of a batch: its index among the factors followed by the
/// characteristics.
using BatchQuantity = std::size_t;

/// The charts of the batch view, as values.
class BatchCharts {
    Q_DECLARE_TR_FUNCTIONS(BatchCharts)
public:
    /// Keys of the legends.
    enum Key { partsKey, sumKey, goodKey, outsideKey, worstKey, limitsKey, meanKey };

    /// A characteristic of a batch: a histogram for each place, all with the same axes, with the
    /// drawing limits and the mean; at most `mostPlaces`, without cells if there is none.
    static ChartGrid histograms(const BatchSummary& summary, const std::string& name,
                                bool tellsIndices);
    static CsvTable histogramsTable(const BatchSummary& summary); ///< all characteristics

    /// Causes of rejected parts: a row for each requirement, the most frequent at the top, with the
    /// cumulative share. A part that fails several counts for each. Without series if there is no
    /// batch or no rejected part.
    static LineChart rejects(const BatchOutcomePtr& outcome);
    static CsvTable rejectsTable(const BatchSummary& summary);

    /// Any two quantities against each other: a point for each recorded part, with the limits;
    /// parts beyond a limit and the worst part are marked.
    static LineChart scatter(const BatchOutcomePtr& outcome, BatchQuantity across,
                             BatchQuantity up);
    static QString quantityName(const BatchOutcome& outcome, BatchQuantity quantity);

private:
    static LineChart histogram(const CharacteristicSummary& summary, bool tellsIndices);
};

} // namespace sparkout
