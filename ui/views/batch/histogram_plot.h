// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "ui/plot/view_plot.h"

#include <vector>

namespace sparkout {

/// One characteristic of a batch, zone beside zone: how many parts came out where, against the
/// drawing limits, with the mean. All cells have the same axes.
class HistogramPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { partsKey, limitsKey, meanKey }; ///< of the legend

    explicit HistogramPlot(QWidget* parent = nullptr);

    /// Of one characteristic; no replot. What was in sight stays while it is the same one.
    void setSummaries(std::vector<CharacteristicSummary> summaries);
    void tellIndices(bool tells) { m_tellsIndices = tells; } ///< from the next summaries on
    void fit() override;
    void restyle() override;

    [[nodiscard]] int cellCount() const { return static_cast<int>(m_cells.size()); }
    [[nodiscard]] QCPBars* bars(int cell) const { return at(cell).bars; }
    [[nodiscard]] QCPItemStraightLine* low(int cell) const { return at(cell).low; } ///< null: none
    [[nodiscard]] QCPItemStraightLine* high(int cell) const { return at(cell).high; }
    [[nodiscard]] QCPItemStraightLine* mean(int cell) const { return at(cell).mean; }
    [[nodiscard]] QCPAxis* valueAxis(int cell) const {
        return at(cell).rect->axis(QCPAxis::atBottom);
    }
    [[nodiscard]] QCPAxis* countAxis(int cell) const {
        return at(cell).rect->axis(QCPAxis::atLeft);
    }
    [[nodiscard]] QString heading(int cell) const { return at(cell).header->text(); }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;                      ///< the bars in sight
    [[nodiscard]] static CsvTable tableOf(const BatchSummary& summary); ///< of every characteristic

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    struct Cell {
        CharacteristicSummary summary;
        QCPTextElement* header = nullptr;
        QCPAxisRect* rect = nullptr;
        QCPBars* bars = nullptr;
        QCPItemStraightLine* low = nullptr;
        QCPItemStraightLine* high = nullptr;
        QCPItemStraightLine* mean = nullptr;
    };

    [[nodiscard]] const Cell& at(int cell) const { return m_cells[static_cast<std::size_t>(cell)]; }
    void build(Cell& cell, int column);
    bool shareWidth(); ///< the cells are alike; whether another layout is needed
    [[nodiscard]] bool hasRoomForNames() const;
    void outline();
    [[nodiscard]] QString headingOf(const CharacteristicSummary& summary) const;

    std::vector<Cell> m_cells;
    bool m_tellsIndices = true;
    QCPRange m_fitted; ///< of the values, as they were fitted last
};

} // namespace sparkout
