// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_history.h"
#include "ui/tables/csv_table.h"
#include "ui/views/layers/layers_look.h"
#include "ui/views/layers/surface_grid.h"

#include <qcustomplot.h>

namespace sparkout {

class SurfaceScene;

/// The accumulated actual feed over the length and the number of the double stroke or revolution, a
/// surface seen in parallel projection. It is turned by moving two hidden axes, whose middles are
/// the angles of sight, so the mouse, the keys and the history of all plots work here too.
class LayersSurface : public QCustomPlot {
    Q_OBJECT
public:
    explicit LayersSurface(QWidget* parent = nullptr);

    void setSeries(LayerSeries series); ///< no replot
    void setDone(LayersDone done);      ///< up to where the cycle stands; no replot
    void setDimmed(bool dim);
    void fit(); ///< back to the first angles
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle();

    [[nodiscard]] const LayerSeries& series() const { return m_series; }
    [[nodiscard]] bool showsStage(int stage) const { return m_choice.shows(stage); }
    [[nodiscard]] const LayersDone& done() const { return m_done; }
    [[nodiscard]] bool isDimmed() const { return m_dim; }
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

    /// For PlotNavigation: the ranges of the two axes.
    [[nodiscard]] PlotHistory::State sight() const;
    void setSight(const PlotHistory::State& sight);
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] CsvTable table() const; ///< one row a number, one column a zone or section

signals:
    void contentChanged(); ///< of the legend

protected:
    void changeEvent(QEvent* event) override;

private:
    void keepAngles(const QCPRange& range, const QCPRange& before, bool sideways);
    [[nodiscard]] double edge() const; ///< of the box along the length, in pixels

    LayerSeries m_series;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    SurfaceScene* m_scene = nullptr;
    LayersDone m_done;
    bool m_dim = false;
    bool m_setting = false; ///< an axis moves the other one
};

} // namespace sparkout
