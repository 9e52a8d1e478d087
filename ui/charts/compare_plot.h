// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/compare_chart.h"
#include "ui/plot/view_plot.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

class HairLine;

/// Actual over accumulated feed of several runs, double stroke by double stroke, over one
/// horizontal axis; each with a second quantity on an axis to the right, force and radius unless
/// chosen otherwise. The colour identifies the quantity, the dash the run.
class ComparePlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr int runKey = 100; ///< in the legend, plus the number; below: a Quantity

    explicit ComparePlot(QWidget* parent = nullptr);

    /// The current run first; keeps the visible range unless it was the whole. No replot. Returns
    /// whether the unit of the horizontal axis changed.
    bool setRuns(std::vector<ComparedFeeds> runs);
    void setAxis(CycleAxis axis); ///< shows all
    /// Sets the quantity of a row's right axis and shows all of its values.
    void setSecond(std::size_t row, Quantity quantity);
    [[nodiscard]] Quantity second(std::size_t row) const { return m_chart.second(row); }
    [[nodiscard]] std::array<Quantity, 4> quantities() const { return m_chart.quantities(); }
    void setMoment(std::optional<double> time_s); ///< for the current run
    void fit() override;
    void restyle() override;

    /// Within a plot, wheel and drag move only the time.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const std::vector<ComparedFeeds>& runs() const { return m_chart.runs(); }
    [[nodiscard]] QCPAxis* axisOf(Quantity quantity) const; ///< value axis of a drawn quantity
    [[nodiscard]] QCPGraph* curve(int number, Quantity quantity) const; ///< null: no such run
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] ReadCurves readCurves() const override; ///< the visible ones, by run
    [[nodiscard]] QCPRange readSpan() const override { return {0, m_chart.end()}; }
    [[nodiscard]] CursorSubject cursorSubject() override;
    [[nodiscard]] CsvTable table() const override; ///< the shown points within the visible range
    [[nodiscard]] QSize minimumSizeHint() const override { return m_leastSize; } ///< legible

signals:
    void timeClicked(double time_s); ///< for the current run

private:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] LegendEntries besides(int key) const override;
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    [[nodiscard]] double weightOf(Quantity quantity) const;
    struct Curve {
        std::size_t run; ///< index in runs()
        Quantity quantity;
        QCPGraph* graph;
    };
    void build();
    void fitTexts();
    void noteLeastSize();
    void fitValues(Quantity quantity);
    void fill();
    [[nodiscard]] const Curve* nearestCurve(const QPointF& at) const;

    CompareChart m_chart;
    std::vector<Curve> m_curves;
    std::array<QCPAxisRect*, CompareChart::rowCount> m_rects{};
    HairLine* m_hairLine = nullptr;
    HairLine* m_momentLine = nullptr;
    std::optional<double> m_moment_s;
    PlotHistory::State m_fitted; ///< last shown by fit()
    QSize m_leastSize;
};

} // namespace sparkout
