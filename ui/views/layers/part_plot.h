// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/stock_layers.h"
#include "ui/plot/chart_plot.h"

namespace sparkout {

class BandLayer;

/// A plot with one cell: the part's length over its axis of rotation, with its zones or sections as
/// bands; radii from the target in micrometres, far above the axis, which is drawn in a strip below
/// the cell after a break line.
class PartPlot : public ChartPlot {
    Q_OBJECT
public:
    void restyle() override;

    [[nodiscard]] QRect painted() const; ///< the cell and the strip below it
    [[nodiscard]] int stripHeight() const;
    void drawPartAxis(QCPPainter& painter) const;

protected:
    explicit PartPlot(QWidget* parent);

    [[nodiscard]] virtual const LayerSeries& zones() const = 0; ///< series with the bands
    [[nodiscard]] static LineChart partChart();                 ///< without series
    void setTexts() override;

private:
    void fillBands();

    BandLayer* m_bands;
};

} // namespace sparkout
