// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/sweep/sweep_plot.h"

namespace sparkout {

/// A sweep over one input: a curve a zone or section, gaps where there is no number, the limits as
/// lines, and shaded where every requirement holds from point to point.
class SweepCurves : public SweepPlot {
    Q_OBJECT
public:
    static constexpr std::size_t mostCurves = 6; ///< of more sections those of the least margin

    explicit SweepCurves(QWidget* parent = nullptr);

    void fit() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    /// The curves in the order of the legend.
    [[nodiscard]] const std::vector<QCPGraph*>& curves() const { return m_curves; }
    [[nodiscard]] const std::vector<QCPGraph*>& limits() const { return m_limits; }
    /// Where every requirement holds, as values of the input.
    [[nodiscard]] std::vector<QCPRange> holding() const;

protected:
    void fill() override;
    void fillMarks() override;
    void colour() override;
    void label() override;
    void showChoice() override;

private:
    void chooseQuantities();
    void addLimits();
    void addBands();

    std::vector<std::size_t> m_quantities; ///< the drawn ones
    std::vector<QCPGraph*> m_curves, m_limits;
    std::vector<QCPItemRect*> m_bands;
    QCPGraph *m_chosenMarks, *m_chosenFoot;
    QCPItemStraightLine* m_present;
    bool m_hasPresent = false;
};

} // namespace sparkout
