// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <array>
#include <qcustomplot.h>
#include <vector>

namespace sparkout {

class BandLayer;
class FeedsChart;

/// The cells that the feeds are drawn in: a column a zone or section, under its name; rows of feed,
/// accumulated feed with radii, and axial feed with normal force. All of them are equally wide and
/// high, their numbers and names as long as has room.
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

    void build(); ///< anew, for the columns of the chart; all curves are gone
    void label(); ///< in the present language
    void fit();
    void restyle();
    [[nodiscard]] QSize leastSize() const; ///< in which all plots are legible
    [[nodiscard]] const std::vector<Column>& columns() const { return m_columns; }
    [[nodiscard]] const Column& column(int index) const {
        return m_columns.at(static_cast<std::size_t>(index));
    }

private:
    void clear();
    void buildCell(std::size_t column, std::size_t row);
    void setUpAxes(QCPAxisRect& rect, std::size_t column, std::size_t row) const;
    /// In two lines, in brief, only the unit, or that and the numbers in small type.
    enum class Naming { full, brief, unit, smallest };
    void nameValueAxes(Naming naming);
    [[nodiscard]] int longestAxisName() const;
    void fitValueAxes(int high, double largest); ///< type of the names
    void setNumberType(double times);            ///< of the usual size
    [[nodiscard]] int alignLabels(QCPAxis::AxisType side, const Column& column) const;
    [[nodiscard]] static int nameWidth(QCPAxis::AxisType side, const Column& column);
    void noteLeastWidth(int numbers); ///< of both value axes
    [[nodiscard]] std::array<int, rowCount> rowMargins() const;
    [[nodiscard]] int heightBesidePlots() const;
    [[nodiscard]] int fitWidths(int left, int right); ///< of the plots
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
