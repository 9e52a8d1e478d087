// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/feeds/cycle_plot.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace sparkout {

/// The plot of the view "Feeds by stage": the curves of a run in a grid of cells. All columns share
/// x, each row shares y.
class FeedsPlot : public CyclePlot {
    Q_OBJECT
public:
    using Detail = FeedsChart::Detail;
    static constexpr int rowCount = FeedsChart::rowCount;

    explicit FeedsPlot(QWidget* parent = nullptr);

    /// Shows columns of a run; keeps the visible range unless it is outside. No replot.
    void setRun(OutcomePtr outcome, const std::vector<int>& shown);
    void setAxis(CycleAxis axis);
    void showTimes(double from_s, double to_s); ///< no replot
    void showAll() { showTimes(0, series().end_s); }
    void fit() override;
    void restyle() override;
    [[nodiscard]] PlotHistory::State visibleRange() const override;
    void setVisibleRange(const PlotHistory::State& state) override;

    [[nodiscard]] const CycleTimes& times() const override { return m_chart.times(); }
    [[nodiscard]] QString timeLabel() const override { return m_chart.timeLabel(); }
    [[nodiscard]] const FeedsChart& feeds() const { return m_chart; }
    [[nodiscard]] const FeedSeries& series() const { return m_chart.series(); }
    [[nodiscard]] int columnCount() const { return static_cast<int>(m_chart.columnCount()); }
    [[nodiscard]] const FeedColumn& source(int column) const {
        return m_chart.source(static_cast<std::size_t>(column));
    }
    [[nodiscard]] const CycleScale& scale() const { return times().scale; }
    [[nodiscard]] double visibleFrom_s() const { return times().from_s; }
    [[nodiscard]] double visibleTo_s() const { return times().to_s; }
    [[nodiscard]] Detail detail() const { return m_chart.detail(); }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] ReadCurves readCurves() const override; ///< without their spread
    /// Adds the curves of another plot over the same times to the cursors.
    void readBeside(std::function<ReadCurves()> curves) { m_beside = std::move(curves); }
    /// The number of a cell, for chart() and bands().
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row * columnCount() + column);
    }
    [[nodiscard]] QCPAxisRect* cell(int column, int row) const {
        return &ChartPlot::cell(at(column, row));
    }

signals:
    void timesChanged(); ///< the visible range has changed
    void gridBuilt();    ///< all axes were replaced

protected:
    void cellsBuilt() override;

private:
    /// The user's ranges for a row's values; empty: fitted.
    struct RowValues {
        ChartSpan left, right;
    };
    [[nodiscard]] ChartGrid made() const;
    void onValuesChanged(std::size_t row);

    FeedsChart m_chart;
    std::function<ReadCurves()> m_beside;
    std::array<RowValues, FeedsChart::rowCount> m_values{};
};

} // namespace sparkout
