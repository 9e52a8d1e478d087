// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <array>
#include <qcustomplot.h>
#include <vector>

namespace sparkout {

class BandLayer;
class FeedsChart;

/// The cells of the feeds: a column for each zone or section, under its name; rows for feed,
/// accumulated feed with radii, and axial feed with normal force. All cells have the same size,
/// with the longest numbers and names that fit.
class FeedsGrid {
    Q_DECLARE_TR_FUNCTIONS(FeedsGrid)
public:
    static constexpr std::size_t rowCount = 3;
    struct Column {
        QCPTextElement* header = nullptr;
        std::array<QCPAxisRect*, rowCount> rects{};
        std::array<BandLayer*, rowCount> bands{};
    };

    FeedsGrid(QCustomPlot& plot, const FeedsChart& chart) : m_plot(plot), m_chart(chart) {}

    void build(); ///< rebuilds for the columns of the chart; removes all curves
    void label(); ///< sets translated texts
    void fit();
    void restyle();
    [[nodiscard]] QSize leastSize() const; ///< size at which all plots are legible
    [[nodiscard]] const std::vector<Column>& columns() const { return m_columns; }
    [[nodiscard]] const Column& column(int index) const {
        return m_columns.at(static_cast<std::size_t>(index));
    }

private:
    void clear();
    void buildCell(std::size_t column, std::size_t row);
    void setUpAxes(QCPAxisRect& rect, std::size_t column, std::size_t row) const;
    /// Names in two lines, short, only the unit, or that and the numbers in a small font.
    enum class Naming { full, brief, unit, smallest };
    void nameValueAxes(Naming naming);
    [[nodiscard]] int longestAxisName() const;
    void fitValueAxes(int high, double largest); ///< font size of the names
    void setNumberType(double times);            ///< relative to the usual size
    [[nodiscard]] int alignLabels(QCPAxis::AxisType side, const Column& column) const;
    [[nodiscard]] static int nameWidth(QCPAxis::AxisType side, const Column& column);
    void noteLeastWidth(int numbers); ///< width of both value axes
    [[nodiscard]] std::array<int, rowCount> rowMargins() const;
    [[nodiscard]] int heightBesidePlots() const;
    [[nodiscard]] int fitWidths(int left, int right); ///< width of the plots
    [[nodiscard]] int fitHeights();
    void showHeaders(int plotWidth, int left, int right);

    QCustomPlot& m_plot;
    const FeedsChart& m_chart;
    QCPLayoutGrid* m_cells = nullptr;
    QCPTextElement* m_timeLabel = nullptr;
    std::vector<Column> m_columns;
    int m_leastWidth = 0;
};

} // namespace sparkout
