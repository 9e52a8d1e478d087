// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/line_chart.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/view_plot.h"

#include <memory>

namespace sparkout {

class ChartMatrix;

/// A plot whose drawing is a chart of curves, or several in cells: legend, table, cursors and the
/// values under the mouse are read from the charts.
class ChartPlot : public ViewPlot {
    Q_OBJECT
public:
    using Maker = std::function<LineChart()>;
    using GridMaker = std::function<ChartGrid()>;

    /// `row` is the row of its cell in the layout.
    explicit ChartPlot(QWidget* parent = nullptr, int row = 0);
    ~ChartPlot() override;

    void setChart(Maker make);    ///< called again for each language; shows everything; no replot
    void setGrid(GridMaker make); ///< the same for several cells
    void remake(); ///< updates the content after a change; keeps the visible range; no replot
    [[nodiscard]] std::size_t cellCount() const { return m_cells.size(); }
    [[nodiscard]] std::size_t columns() const { return m_grid.columns; }
    [[nodiscard]] const LineChart& chart(std::size_t cell = 0) const { return m_grid.cells[cell]; }
    [[nodiscard]] QCPAxisRect& cell(std::size_t cell = 0) const { return *m_cells[cell].rect; }
    [[nodiscard]] QCPTextElement* heading(std::size_t cell) const;      ///< null: none
    [[nodiscard]] QCPTextElement* caption() const { return m_caption; } ///< null: none
    [[nodiscard]] BandLayer* bands(std::size_t cell) const;             ///< null: none
    [[nodiscard]] QCPAxis& across(std::size_t cell = 0) const;          ///< axis of the places
    [[nodiscard]] QCPAxis& up(std::size_t cell = 0) const;              ///< axis of the values
    [[nodiscard]] QCPAxis& second(std::size_t cell = 0) const; ///< second axis of the values
    [[nodiscard]] QPointF pixelOf(const XY& point) const;      ///< in the first cell
    using ViewPlot::shows;

    void fit() override;
    void fitValues(); ///< fits only the axes of the values
    void refit();     ///< fits the axes that were not moved since they were fitted
    void restyle() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange readSpan() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void pointClicked(std::size_t series, std::size_t point);
    /// Within the cell, also with the right button.
    void placeClicked(double place, double value);

protected:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void resizeEvent(QResizeEvent* event) override;
    [[nodiscard]] bool hasFittedValues() const; ///< not moved since they were fitted
    void takeCharts();                          ///< makes and draws the charts; fitValues() follows
    void fitPlaces();                           ///< fits only the axes of the places
    virtual void cellsBuilt() {}                ///< all axes were replaced
    [[nodiscard]] std::optional<std::size_t> cellAt(const QPointF& at) const;
    [[nodiscard]] std::optional<XY> placeAt(const QPointF& at) const; ///< within a cell

private:
    class ZoneLayer;
    struct Point {
        std::size_t series, point;
    };
    struct Cell {
        QCPAxisRect* rect;
        QCPTextElement* heading = nullptr;
        std::unique_ptr<BandLayer> bands = {};
    };

    [[nodiscard]] QColor colourOf(const ChartColour& colour) const; ///< faint while dimmed
    [[nodiscard]] QColor areaOf(const ChartColour& colour, int alpha) const;
    /// The edge of a line or mark: its outline, or else its own colour.
    [[nodiscard]] QColor outlineOf(const ChartSeries& series) const;
    [[nodiscard]] QColor ribbonOf(const ChartSeries& series) const;
    [[nodiscard]] QCPScatterStyle markOf(const ChartSeries& series) const;
    [[nodiscard]] QPen penOf(QPen pen, const ChartColour& colour) const;
    [[nodiscard]] std::optional<Point> pointAt(const QPointF& at) const; ///< in the first cell
    void build(); ///< builds the cells of the grid
    void setUpAxes(std::size_t cell);
    void colourAxes();
    void drawCharts();
    void drawCell(std::size_t cell);
    void drawSeries(std::size_t cell, const ChartSeries& series);
    void drawBars(std::size_t cell, const ChartSeries& series);
    void drawArea(std::size_t cell, const ChartSeries& series);
    QCPGraph* addGraphOf(std::size_t cell, const ChartSeries& series,
                         const std::vector<XY>& points);
    void drawPath(std::size_t cell, const ChartSeries& series);
    void drawMap(std::size_t cell, const ChartMap& map);
    void addScale(std::size_t cell);
    void follow(const QCPAxisRect& rect); ///< its values, for tieSecond()
    void tieSecond();                     ///< sets the second axes that are tied to the first
    void styleTexts();                    ///< of headings and caption
    void followValues();

    GridMaker m_make;
    ChartGrid m_grid{.cells = {LineChart()}};
    std::vector<Cell> m_cells;
    std::size_t m_builtColumns = 1; ///< of m_cells
    QCPTextElement* m_caption = nullptr;
    std::unique_ptr<ChartMatrix> m_matrix; ///< lays out rows that share their values
    bool m_isFitting = false;
    std::optional<QCPRange> m_fittedPlaces, m_fittedValues; ///< of the first cell in the last fit
    std::vector<std::unique_ptr<ZoneLayer>> m_zones;
    QCPGraph* m_stacked = nullptr;    ///< upper edge of the current stack
    QCPColorScale* m_scale = nullptr; ///< colours of the map, if there is one
};

} // namespace sparkout
