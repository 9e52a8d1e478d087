// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"

#include <qcustomplot.h>

#include <vector>

namespace sparkout {

/// One characteristic of a batch, zone beside zone: how many parts came out where, against the
/// limits of the drawing, with the mean. All cells have the same axes.
class HistogramPlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void setSummaries(std::vector<CharacteristicSummary> summaries); ///< of one characteristic
    void setDimmed(bool dim);
    void fit();
    void retranslate();
    void restyle();

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

    /// "Mean diameter", "Radial runout", "Machining time".
    [[nodiscard]] static QString name(const Characteristic& characteristic);

protected:
    void changeEvent(QEvent* event) override;

private:
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
    [[nodiscard]] QCPItemStraightLine* addLine(const Cell& cell, double value);
    void link(const QCPAxis* moved);
    [[nodiscard]] QString headingOf(const CharacteristicSummary& summary) const;

    std::vector<Cell> m_cells;
    bool m_dim = false;
    bool m_linking = false;
};

} // namespace sparkout
