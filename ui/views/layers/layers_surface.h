// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/stock_layers.h"
#include "ui/plot/view_plot.h"
#include "ui/views/layers/surface_grid.h"

namespace sparkout {

/// The accumulated actual feed over the length and the number of the double stroke or revolution, a
/// surface seen in parallel projection. It is turned by moving two hidden axes, whose middles are
/// the angles of view, so the mouse, the keys and the history of all plots work here too.
class LayersSurface : public ViewPlot {
    Q_OBJECT
public:
    explicit LayersSurface(QWidget* parent = nullptr);

    void setSeries(LayerSeries series); ///< no replot
    void setDone(LayersDone done);      ///< up to where the cycle stands; no replot
    void fit() override;                ///< back to the first angles
    void restyle() override;

    [[nodiscard]] const LayerSeries& series() const { return m_series; }
    [[nodiscard]] bool showsStage(int stage) const { return shows(stage); }
    [[nodiscard]] const LayersDone& done() const { return m_done; }
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] double azimuth() const;   ///< about the vertical axis [°]
    [[nodiscard]] double elevation() const; ///< of the eye over the ground, 0…90 [°]
    [[nodiscard]] double zoom() const;      ///< 1: all in sight
    /// Where a point of the box is drawn, from (0, 0, 0) to (1, 1, 1): along the length, over the
    /// numbers, upwards.
    [[nodiscard]] QPointF project(double x, double y, double z) const;
    /// How far a point of the box is in front, in units of the box.
    [[nodiscard]] double nearness(double x, double y, double z) const;
    [[nodiscard]] SurfaceGrid grid() const; ///< what is drawn

    /// The ranges of the two axes.
    [[nodiscard]] PlotHistory::State visibleRange() const override;
    void setVisibleRange(const PlotHistory::State& range) override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable
    table() const override; ///< one row a number, one column a zone or section

private:
    void keepAngles(const QCPRange& range, const QCPRange& before, bool sideways);
    [[nodiscard]] double edge() const; ///< of the box along the length, in pixels

    LayerSeries m_series;
    QCPAxisRect* m_rect = nullptr;
    LayersDone m_done;
    bool m_setting = false; ///< an axis moves the other one
};

} // namespace sparkout
