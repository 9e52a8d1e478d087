// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

#include <qcustomplot.h>
#include <vector>

namespace sparkout {

class ChartPlot;

/// Lays out the cells of a chart plot whose rows share their values: all cells have the same size,
/// only outer axes have numbers and names, with the longest names and the largest numbers that fit.
class ChartMatrix {
public:
    explicit ChartMatrix(ChartPlot& plot) : m_plot(plot) {}

    void setUp(); ///< after the axes of the cells were set up
    void fit();
    void restyle();
    [[nodiscard]] QSize leastSize() const; ///< size at which all cells are legible

private:
    /// Names in two lines, short, only the unit, or that and the numbers in a small font.
    enum class Naming { full, brief, unit, smallest };
    [[nodiscard]] std::size_t columns() const;
    [[nodiscard]] std::size_t rows() const;
    [[nodiscard]] QCPAxisRect& rect(std::size_t column, std::size_t row) const;
    /// The value axes with numbers: left of the first column, right of the last.
    [[nodiscard]] std::vector<QCPAxis*> outerAxes(QCPAxis::AxisType side) const;
    [[nodiscard]] std::vector<QCPAxis*> outerAxes() const;
    void setUpAxes(std::size_t column, std::size_t row);
    void nameValueAxes(Naming naming);
    [[nodiscard]] int longestAxisName() const;
    void fitValueAxes(int high, double largest); ///< font size of the names
    void setNumberType(double times);            ///< relative to the usual size
    [[nodiscard]] int alignLabels(QCPAxis::AxisType side) const;
    [[nodiscard]] int nameWidth(QCPAxis::AxisType side) const;
    void noteLeastWidth(int numbers); ///< width of both value axes
    [[nodiscard]] int topMargin(std::size_t row) const;
    [[nodiscard]] int bottomMargin(std::size_t row) const;
    [[nodiscard]] int heightBesidePlots() const;
    [[nodiscard]] int fitWidths(int left, int right); ///< width of the plots
    [[nodiscard]] int fitHeights();
    void showHeaders(int plotWidth, int left, int right);

    ChartPlot& m_plot;
    QString m_named; ///< name of the first axis, to which the least width belongs
    int m_leastWidth = 0;
};

} // namespace sparkout
