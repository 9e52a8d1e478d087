// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/line_chart.h"
#include "ui/plot/view_plot.h"

#include <memory>

namespace sparkout {

/// A plot whose drawing is a chart of curves: legend, table, cursors and the values under the mouse
/// are read from the chart.
class ChartPlot : public ViewPlot {
    Q_OBJECT
public:
    using Maker = std::function<LineChart()>;

    /// `row` is the row of its cell in the layout.
    explicit ChartPlot(QWidget* parent = nullptr, int row = 0);
    ~ChartPlot() override;

    void setChart(Maker make); ///< called again for each language; shows everything; no replot
    void remake(); ///< updates the content after a change; keeps the visible range; no replot
    [[nodiscard]] const LineChart& chart() const { return m_chart; }
    [[nodiscard]] QCPAxisRect& cell() const { return *m_rect; }
    [[nodiscard]] QCPAxis& across() const; ///< axis of the places
    [[nodiscard]] QCPAxis& up() const;     ///< axis of the values
    [[nodiscard]] QPointF pixelOf(const XY& point) const;
    using ViewPlot::shows;

    void fit() override;
    virtual void fitValues(); ///< fits only the axis of the values
    void restyle() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange readSpan() const override;

signals:
    void pointClicked(std::size_t series, std::size_t point);
    /// Within the cell, also with the right button.
    void placeClicked(double place, double value);

protected:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    class ZoneLayer;
    struct Point {
        std::size_t series, point;
    };

    [[nodiscard]] QCPAxis& second() const;
    [[nodiscard]] QColor colourOf(const ChartColour& colour) const; ///< faint while dimmed
    [[nodiscard]] QColor areaOf(const ChartColour& colour, int alpha) const;
    /// The edge of a line or mark: its outline, or else its own colour.
    [[nodiscard]] QColor outlineOf(const ChartSeries& series) const;
    [[nodiscard]] QColor ribbonOf(const ChartSeries& series) const;
    [[nodiscard]] QCPScatterStyle markOf(const ChartSeries& series) const;
    [[nodiscard]] QPen penOf(QPen pen, const ChartColour& colour) const;
    [[nodiscard]] std::optional<Point> pointAt(const QPointF& at) const;
    [[nodiscard]] std::optional<XY> placeAt(const QPointF& at) const; ///< within the cell
    void setUpAxes();
    void drawChart();
    void drawSeries(const ChartSeries& series);
    void drawBars(const ChartSeries& series);
    void drawArea(const ChartSeries& series);
    QCPGraph* addGraphOf(const ChartSeries& series, const std::vector<XY>& points);
    void drawPath(const ChartSeries& series);
    void followValues(); ///< for a second axis tied to the first
    void addScale();
    void drawMap(const ChartMap& map);

    Maker m_make;
    LineChart m_chart;
    QCPAxisRect* m_rect;
    std::vector<std::unique_ptr<ZoneLayer>> m_zones;
    QCPGraph* m_stacked = nullptr;    ///< upper edge of the current stack
    QCPColorScale* m_scale = nullptr; ///< colours of the map, if there is one
};

} // namespace sparkout
