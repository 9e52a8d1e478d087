// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/session/studies.h"

#include <optional>

namespace sparkout {

/// A factor or a characteristic of a batch, by its number among the factors and then the
/// characteristics.
using BatchQuantity = std::size_t;
[[nodiscard]] QString quantityName(const BatchOutcome& outcome, BatchQuantity quantity);

/// Any two quantities of a batch against each other: a point a part that is kept one by one, those
/// beyond a limit of either and the worst part marked, with the limits.
class ScatterPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { goodKey, outsideKey, worstKey, limitsKey }; ///< of the legend

    explicit ScatterPlot(QWidget* parent = nullptr);

    void setBatch(BatchOutcomePtr outcome, BatchQuantity across, BatchQuantity up); ///< no replot
    void fit() override;
    void restyle() override;

    [[nodiscard]] QCPGraph* graph(Key key) const; ///< of the points
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the points in sight

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void fill();
    void addLimits(BatchQuantity quantity, bool upright);
    [[nodiscard]] bool outside(std::size_t row) const; ///< the limits of what is shown

    BatchOutcomePtr m_outcome;
    BatchQuantity m_across = 0, m_up = 0;
    QCPAxisRect* m_rect = nullptr;
    QCPGraph *m_good = nullptr, *m_outside = nullptr, *m_worst = nullptr;
    std::vector<QCPItemStraightLine*> m_limits;
};

} // namespace sparkout
