// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/sweep/sweep_plot.h"

namespace sparkout {

/// A sweep over two inputs: a field of colours, a cell a point, of several zones the worst; lines
/// where the quantity meets its limit and around where every requirement holds.
class SweepMap : public SweepPlot {
    Q_OBJECT
public:
    explicit SweepMap(QWidget* parent = nullptr);

    void fit() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] QCPColorMap* map() const { return m_map; }
    [[nodiscard]] QCPCurve* limitLine() const { return m_limit; }
    [[nodiscard]] QCPCurve* holdsLine() const { return m_holds; }

protected:
    void fill() override;
    void fillMarks() override;
    void colour() override;
    void label() override;

private:
    void fillCells();
    void fillContours();
    [[nodiscard]] double worstShown(std::size_t point) const;

    QCPColorMap* m_map;
    QCPColorScale* m_scale;
    QCPCurve *m_limitHalo, *m_limit, *m_holdsHalo, *m_holds;
    QCPGraph *m_present, *m_chosenMark;
};

} // namespace sparkout
