// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/band_layer.h"
#include "ui/plot/view_plot.h"
#include "ui/views/feeds/feeds_chart.h"
#include "ui/views/feeds/feeds_grid.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

class HairLine;

/// The plot of the view "Feeds by stage": the curves of a run in a grid of cells. All columns share
/// x, each row shares y.
class FeedsPlot : public ViewPlot {
    Q_OBJECT
public:
    using Detail = FeedsChart::Detail;
    static constexpr int rowCount = FeedsGrid::rowCount;

    explicit FeedsPlot(QWidget* parent = nullptr);

    /// Shows columns of a run; keeps the visible range unless it is outside. No replot.
    void setRun(OutcomePtr outcome, const std::vector<int>& shown);
    void setAxis(CycleAxis axis);
    void setMoment(std::optional<double> time_s); ///< moment of the cycle; empty: its end
    void showTimes(double from_s, double to_s);   ///< no replot
    void fitValues() { m_values = {}; }           ///< from the next showTimes() on
    void showAll() { showTimes(0, series().end_s); }
    void fit() override {
        fitValues();
        showAll();
    }
    void restyle() override;
    [[nodiscard]] PlotHistory::State visibleRange() const override;
    void setVisibleRange(const PlotHistory::State& state) override;
    /// Within a plot, wheel and drag move only the time.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const FeedSeries& series() const { return m_chart.series(); }
    [[nodiscard]] int columnCount() const { return static_cast<int>(m_chart.columnCount()); }
    [[nodiscard]] const FeedColumn& source(int column) const {
        return m_chart.source(static_cast<std::size_t>(column));
    }
    [[nodiscard]] const CycleScale& scale() const { return m_chart.scale(); }
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] double visibleFrom_s() const { return m_chart.from_s(); }
    [[nodiscard]] double visibleTo_s() const { return m_chart.to_s(); }
    [[nodiscard]] Detail detail() const { return m_chart.detail(); }
    [[nodiscard]] QString timeLabel() const { return m_chart.timeLabel(); }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override { return m_chart.table(choice()); }
    [[nodiscard]] ReadCurves readCurves() const override; ///< without their spread
    [[nodiscard]] CursorSubject cursorSubject() override;
    /// Adds the curves of another plot over the same times to the cursors.
    void readBeside(std::function<ReadCurves()> curves) { m_beside = std::move(curves); }
    [[nodiscard]] BandLayer* bands(int column, int row) const {
        return m_grid.column(column).bands.at(static_cast<std::size_t>(row));
    }
    [[nodiscard]] QCPAxisRect* cell(int column, int row) const {
        return m_grid.column(column).rects.at(static_cast<std::size_t>(row));
    }
    [[nodiscard]] QCPGraph* curve(int column, Quantity quantity, Edge edge) const;
    [[nodiscard]] std::vector<Band> stageBands() const;
    [[nodiscard]] static QColor stepColour(Zone zone, Step step, const QPalette& palette);
    [[nodiscard]] QSize minimumSizeHint() const override { return m_grid.leastSize(); }

signals:
    void timesChanged(); ///< the visible range has changed
    void gridBuilt();    ///< all axes were replaced
    void timeClicked(double time_s);
    void pointedBand(const QString& text); ///< full name of the band under the mouse

protected:
    void setTexts() override;
    void takeLook(bool font) override;
    void showChoice() override; ///< hidden curves are neither drawn nor used for scaling
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Curve {
        std::size_t column;
        Quantity quantity;
        Edge edge;
        QCPGraph* graph;
    };
    /// The user's ranges for a row's values.
    struct RowValues {
        bool own = false;
        QCPRange left, right;
    };
    void buildGrid();
    void addCurves(std::size_t column);
    void addCurve(std::size_t column, Quantity quantity, QCPAxis* value);
    void linkAxes();
    void showScale(); ///< after a change of axis or unit
    void onTimesChanged(const QCPRange& range);
    void onValuesChanged(QCPAxis* axis, const QCPRange& range);
    void fill();
    void fillBands();
    void scaleValues();
    void scaleRow(std::size_t row, QCPAxis::AxisType type, double low, double high);
    [[nodiscard]] std::vector<Band> stepBands(std::size_t column) const;
    [[nodiscard]] QColor colourOf(Quantity quantity) const;

    FeedsChart m_chart;
    FeedsGrid m_grid;
    HairLine* m_momentLine;
    HairLine* m_hairLine;
    std::optional<double> m_moment_s;
    std::function<ReadCurves()> m_beside;
    std::vector<Curve> m_curves;
    bool m_linking = false;
    std::array<RowValues, FeedsGrid::rowCount> m_values{};
};

} // namespace sparkout
