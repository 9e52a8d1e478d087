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
/// chosen otherwise. The colour says which quantity, the dash which run.
class ComparePlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr int runKey = 100; ///< of the legend, plus the number; below: a Quantity

    explicit ComparePlot(QWidget* parent = nullptr);

    /// The present run first; what is visible stays unless all was. No replot.
    /// Returns whether the horizontal axis is in another unit than before.
    bool setRuns(std::vector<ComparedFeeds> runs);
    void setAxis(CycleAxis axis); ///< shows all
    /// On the right-hand axis of a row, in its place; shows all of its values.
    void setSecond(std::size_t row, Quantity quantity);
    [[nodiscard]] Quantity second(std::size_t row) const { return m_chart.second(row); }
    [[nodiscard]] std::array<Quantity, 4> quantities() const { return m_chart.quantities(); }
    void setMoment(std::optional<double> time_s); ///< of the present run
    void fit() override;
    void restyle() override;

    /// Within a plot, wheel and drag move the time only.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const std::vector<ComparedFeeds>& runs() const { return m_chart.runs(); }
    [[nodiscard]] QCPAxis* axisOf(Quantity quantity) const; ///< of a quantity that is drawn
    [[nodiscard]] QCPGraph* curve(int number, Quantity quantity) const; ///< null: no such run
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] ReadCurves readCurves() const override; ///< the shown ones, run by run
    [[nodiscard]] QCPRange readSpan() const override { return {0, m_chart.end()}; }
    [[nodiscard]] CursorSubject cursorSubject() override;
    [[nodiscard]] CsvTable table() const override; ///< the shown points within the visible range
    [[nodiscard]] QSize minimumSizeHint() const override { return m_leastSize; } ///< legible

signals:
    void timeClicked(double time_s); ///< of the present run

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
    PlotHistory::State m_fitted; ///< what fit() showed
    QSize m_leastSize;
};

} // namespace sparkout
