// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/chart_plot.h"
#include "ui/views/study/state_grid_text.h"

#include <optional>
#include <utility>

namespace sparkout {

class StateGridLayer;

/// The parts that can be hidden: keys of the legend.
enum class GridPart { rulePath, provenPath, wrong, noMove, moves };

/// The coordinate grid of dynamic programming: stock left across, feeds up, a cell for each state,
/// at a moment of its filling. A click selects a state.
class StateGridPlot : public ChartPlot {
    Q_OBJECT
public:
    explicit StateGridPlot(QWidget* parent = nullptr);

    /// Null: none; keeps the moment if the same grid gets its proven answer, otherwise sets the
    /// last one. No replot.
    void setGrid(StateGridOutcomePtr outcome);
    void setMoment(int number) { m_number = number; } ///< no replot
    [[nodiscard]] const StateGridOutcomePtr& outcome() const { return m_outcome; }
    [[nodiscard]] int moment() const { return m_number; }
    [[nodiscard]] QRectF stateRect(int level, std::size_t feed) const;
    [[nodiscard]] QString cellText(int level, std::size_t feed) const;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< every state

signals:
    void stateClicked(int level, std::size_t feed);

protected:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    [[nodiscard]] LineChart made() const; ///< axes and legend of the cells
    void thinLabels();
    [[nodiscard]] std::optional<std::pair<int, std::size_t>> stateAt(const QPointF& at) const;

    StateGridOutcomePtr m_outcome;
    int m_number = 0;
    QSharedPointer<QCPAxisTickerText> m_levels, m_feeds; ///< labels of the states
    StateGridLayer* m_layer;
};

} // namespace sparkout
