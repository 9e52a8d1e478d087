// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/views/sweep/sweep_shown.h"

#include <optional>
#include <vector>

namespace sparkout {

/// A sweep over two inputs: a colour map with a cell for each point, the worst of several zones;
/// with lines where the quantity meets its limit and around the cells in which every requirement is
/// met.
class SweepMap : public ViewPlot {
    Q_OBJECT
public:
    explicit SweepMap(QWidget* parent = nullptr);

    void setSweep(SweepShown shown); ///< shows everything; no replot
    void setMarks(SweepShown shown); ///< changes only the current or the chosen point; no replot
    void fit() override;
    void restyle() override;
    [[nodiscard]] QPointF pixelOf(std::size_t point) const; ///< the middle of the point's cell
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the visible points
    [[nodiscard]] QCPColorMap* map() const { return m_map; }
    [[nodiscard]] QCPCurve* limitLine() const { return m_limit; }
    [[nodiscard]] QCPCurve* holdsLine() const { return m_holds; }

signals:
    void pointChosen(std::size_t point); ///< by a click of the left or the right button

protected:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    [[nodiscard]] bool empty() const { return m_shown.empty() || !m_shown.isMap(); }
    [[nodiscard]] QCPAxis* across() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* up() const { return m_rect->axis(QCPAxis::atLeft); }
    /// The point nearest to a pixel within the axis rect.
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF& pixel) const;
    [[nodiscard]] QCPGraph* addMarks(int key);            ///< a graph of signs without a line
    [[nodiscard]] std::vector<ChartSeries> signs() const; ///< points without values
    void fillCells();
    void fillContours();
    void fillMarks();
    [[nodiscard]] double worstShown(std::size_t point) const;

    SweepShown m_shown;
    QCPAxisRect* m_rect;
    QCPColorMap* m_map;
    QCPColorScale* m_scale;
    QCPCurve *m_limitHalo, *m_limit, *m_holdsHalo, *m_holds;
    QCPGraph *m_refused, *m_notReached, *m_present, *m_chosenMark;
};

} // namespace sparkout
