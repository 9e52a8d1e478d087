// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/stock_layers.h"
#include "ui/chart/view_plot.h"

#include <QColor>
#include <QString>

#include <array>
#include <cstddef>
#include <vector>

/// The surface of the layers: its values, and its plot.
namespace sparkout {

/// A piece of the surface with lines of one colour: a stage, or the newest layer at the moment of
/// the cycle. Its points lie in rows, one over each of `numbers`; a step up or down has two points
/// at one length.
struct SurfaceSheet {
    int stage = 1;
    bool newest = false;
    std::vector<double> lengths_mm; ///< lengths of the points of a row, never falling
    std::vector<double> numbers;    ///< numbers of the rows, rising
    std::vector<double> feeds_um;   ///< accumulated actual feeds, row by row
    std::vector<QColor> colours;    ///< colours of the facets between the points, row by row
    QColor line;                    ///< about the facets

    bool operator==(const SurfaceSheet&) const = default;
    [[nodiscard]] std::size_t columns() const { return lengths_mm.size(); }
    [[nodiscard]] double feed_um(std::size_t row, std::size_t column) const {
        return feeds_um[row * columns() + column];
    }
    [[nodiscard]] const QColor& colour(std::size_t row, std::size_t column) const {
        return colours[row * (columns() - 1) + column];
    }
};

struct SurfaceScale {
    QString title;
    double most = 1; ///< beginning at 0
    bool operator==(const SurfaceScale&) const = default;
};

struct SurfaceGrid {
    std::vector<SurfaceSheet> sheets;
    std::array<SurfaceScale, 3> scales; ///< length, number, feed
    QColor wall, edge;                  ///< colours of the box; opaque
    bool operator==(const SurfaceGrid&) const = default;
};

[[nodiscard]] SurfaceGrid makeSurfaceGrid(const LayerSeries& series, const LayersDone& done,
                                          const CurveChoice& choice, const QPalette& palette,
                                          bool dim);

/// The accumulated actual feed over the length and the number of the double stroke or revolution, a
/// surface seen in parallel projection. It is turned by moving two hidden axes, whose middles are
/// the angles of view, so that mouse, keys and history work as in all plots.
class LayersSurface : public ViewPlot {
    Q_OBJECT
public:
    explicit LayersSurface(QWidget* parent = nullptr);

    void setSeries(LayerSeries series); ///< no replot
    void setDone(LayersDone done);      ///< up to the moment of the cycle; no replot
    void fit() override;                ///< back to the first angles
    void restyle() override;

    [[nodiscard]] const LayerSeries& series() const { return m_series; }
    [[nodiscard]] bool showsStage(int stage) const { return shows(stage); }
    [[nodiscard]] const LayersDone& done() const { return m_done; }
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] double azimuth() const;   ///< about the vertical axis [°]
    [[nodiscard]] double elevation() const; ///< elevation of the eye, 0…90 [°]
    [[nodiscard]] double zoom() const;      ///< 1: all in sight
    /// The position of a point of the box on the plot, from (0, 0, 0) to (1, 1, 1): along the
    /// length, over the numbers, upwards.
    [[nodiscard]] QPointF project(double x, double y, double z) const;
    /// The depth of a point of the box towards the viewer, in units of the box.
    [[nodiscard]] double nearness(double x, double y, double z) const;
    [[nodiscard]] SurfaceGrid grid() const; ///< the drawn surface

    /// The ranges of the two axes.
    [[nodiscard]] PlotHistory::State visibleRange() const override;
    void setVisibleRange(const PlotHistory::State& range) override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable
    table() const override; ///< one row for each number, one column for each zone or section

private:
    void keepAngles(const QCPRange& range, const QCPRange& before, bool sideways);
    [[nodiscard]] double edge() const; ///< edge of the box along the length, in pixels

    LayerSeries m_series;
    QCPAxisRect* m_rect = nullptr;
    LayersDone m_done;
    bool m_setting = false; ///< true while one axis moves the other
};

} // namespace sparkout
