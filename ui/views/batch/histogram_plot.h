// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "ui/plot/view_plot.h"

#include <vector>

namespace sparkout {

/// One characteristic of a batch, with a histogram for each zone, the drawing limits and the mean.
/// All cells have the same axes.
class HistogramPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { partsKey, limitsKey, meanKey }; ///< keys of the legend

    explicit HistogramPlot(QWidget* parent = nullptr);

    /// Sets the summaries of one characteristic without a replot. The visible range is kept if the
    /// characteristic is the same.
    void setSummaries(std::vector<CharacteristicSummary> summaries);
    void tellIndices(bool tells) { m_tellsIndices = tells; } ///< applies to the next summaries
    /// Whether the headings name the characteristic of their Ppk; applies to the next summaries.
    void nameIndices(bool names) { m_namesIndices = names; }
    void fit() override;
    void restyle() override;

    [[nodiscard]] int cellCount() const { return static_cast<int>(m_cells.size()); }
    [[nodiscard]] QCPBars* bars(int cell) const { return at(cell).bars; }
    [[nodiscard]] QCPItemStraightLine* low(int cell) const { return at(cell).low; } ///< or null
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
    [[nodiscard]] CsvTable table() const override;                      ///< the visible bars
    [[nodiscard]] static CsvTable tableOf(const BatchSummary& summary); ///< all characteristics

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
    bool shareWidth(); ///< makes the cells equally wide; true if another layout is needed
    [[nodiscard]] bool hasRoomForNames() const;
    void outline();
    [[nodiscard]] QString headingOf(const CharacteristicSummary& summary) const;

    std::vector<Cell> m_cells;
    bool m_tellsIndices = true, m_namesIndices = false;
    QCPRange m_fitted; ///< value range of the last fit
};

} // namespace sparkout
