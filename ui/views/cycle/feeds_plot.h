// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/chart_plot.h"
#include "ui/views/cycle/feeds_chart.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

class HairLine;

/// Charts over the time of a cycle, all within the same visible times. The values follow what is
/// visible; lines mark the moment of the cycle and the time under the mouse.
class CyclePlot : public ChartPlot {
    Q_OBJECT
public:
    explicit CyclePlot(QWidget* parent);

    [[nodiscard]] virtual const CycleTimes& times() const = 0;
    [[nodiscard]] virtual QString timeLabel() const = 0; ///< "Time, min"
    void setMoment(std::optional<double> time_s);        ///< moment of the cycle; empty: its end
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    /// Within a plot, wheel and drag move only the time.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;
    [[nodiscard]] CursorSubject cursorSubject() override;

signals:
    void timesWanted(double from_s, double to_s); ///< the user moved them
    void timeClicked(double time_s);

protected:
    void follow(); ///< updates content and ranges to the visible times; no replot
    [[nodiscard]] bool isFollowing() const { return m_isFollowing; }
    void showChoice() override; ///< hidden curves are not used for scaling
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    void cellsBuilt() override;

private:
    void onTimesChanged(const QCPRange& range);

    HairLine* m_momentLine;
    HairLine* m_hairLine;
    std::optional<double> m_moment_s;
    QString m_label; ///< of the last content
    bool m_isFollowing = false;
};

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
