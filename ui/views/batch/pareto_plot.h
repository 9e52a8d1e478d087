// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/session/studies.h"

#include <vector>

namespace sparkout {

/// Why the parts of a batch fail: a row a requirement, the most frequent at the top, with the share
/// that the causes so far have of all. A part that fails several counts at each of them.
class ParetoPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { partsKey, sumKey }; ///< of the legend

    explicit ParetoPlot(QWidget* parent = nullptr);

    void setBatch(BatchOutcomePtr outcome); ///< no replot
    void fit() override;
    void restyle() override;

    [[nodiscard]] bool empty() const { return causes().empty(); } ///< no part fails
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] static CsvTable tableOf(const BatchSummary& summary);
    [[nodiscard]] QCPBars* bars() const { return m_bars; }
    [[nodiscard]] QCPGraph* sum() const { return m_sum; } ///< of the shares [%]
    [[nodiscard]] QStringList names() const;              ///< of the rows, from the top

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    [[nodiscard]] const std::vector<RejectCause>& causes() const;
    [[nodiscard]] double sumAt(std::size_t row) const; ///< [%]
    [[nodiscard]] static QString nameOf(const RejectCause& cause);

    BatchOutcomePtr m_outcome;
    QCPAxisRect* m_rect = nullptr;
    QCPBars* m_bars = nullptr;
    QCPGraph* m_sum = nullptr;
};

} // namespace sparkout
