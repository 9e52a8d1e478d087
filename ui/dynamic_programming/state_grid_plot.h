// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dynamic_programming/state_grid_layer.h"
#include "ui/plot/view_plot.h"

#include <optional>
#include <utility>

namespace sparkout {

/// The coordinate grid of dynamic programming: stock left across, feeds up, a cell for each state,
/// at a moment of its filling. A click selects a state.
class StateGridPlot : public ViewPlot {
    Q_OBJECT
public:
    explicit StateGridPlot(QWidget* parent = nullptr);

    /// Null: none; keeps the moment if the same grid gets its proven answer, otherwise sets the
    /// last one. No replot.
    void setGrid(StateGridOutcomePtr outcome);
    void setMoment(int number); ///< no replot
    [[nodiscard]] const StateGridOutcomePtr& outcome() const { return m_outcome; }
    [[nodiscard]] int moment() const { return m_layer->moment(); }
    [[nodiscard]] QRectF cell(int level, std::size_t feed) const {
        return m_layer->cell(level, feed);
    }
    [[nodiscard]] QString cellText(int level, std::size_t feed) const {
        return m_layer->cellText(level, feed);
    }
    void fit() override;
    void restyle() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< every state

signals:
    void stateClicked(int level, std::size_t feed);

protected:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    void thinLabels();
    [[nodiscard]] std::optional<std::pair<int, std::size_t>> stateAt(const QPointF& at) const;
    [[nodiscard]] QCPAxis* across() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* up() const { return m_rect->axis(QCPAxis::atLeft); }

    StateGridOutcomePtr m_outcome;
    QCPAxisRect* m_rect;
    StateGridLayer* m_layer;
};

} // namespace sparkout
