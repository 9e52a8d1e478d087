// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/views/sweep/phase_outcome.h"

namespace sparkout {

class FailingLayer;

/// Size against stock: the largest and the smallest diameter of all zones or sections over the
/// stock, piece by piece, against the tolerance band; stocks that fail are hatched. Within a piece
/// the diameters are linear in the stock, so the picture is exact.
class PhasePlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { largestKey, smallestKey, toleranceKey, failsKey, statedKey };

    explicit PhasePlot(QWidget* parent = nullptr);

    void setPhases(PhaseOutcomePtr phases); ///< null: none; no replot
    [[nodiscard]] const PhaseOutcomePtr& phases() const { return m_phases; }
    void fit() override;
    void restyle() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the pieces in sight

    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] QCPCurve* largest() const { return m_largest; }
    [[nodiscard]] QCPCurve* smallest() const { return m_smallest; }
    [[nodiscard]] std::vector<QCPRange> failing() const; ///< stocks, as hatched
    [[nodiscard]] double statedStock_mm() const;         ///< where its line stands

protected:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    void fill();
    [[nodiscard]] QCPAxis* across() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* up() const { return m_rect->axis(QCPAxis::atLeft); }

    PhaseOutcomePtr m_phases;
    QCPAxisRect* m_rect;
    FailingLayer* m_failing;
    QCPItemRect* m_field;
    QCPCurve *m_largest, *m_smallest;
    QCPItemStraightLine* m_stated;
};

} // namespace sparkout
