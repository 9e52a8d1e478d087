// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/compare_chart.h"
#include "ui/plot/chart_plot.h"

#include <optional>
#include <vector>

namespace sparkout {

class HairLine;

/// Actual over accumulated feed of several runs, double stroke by double stroke, over one
/// horizontal axis; each with a second quantity on an axis to the right, force and radius unless
/// chosen otherwise.
class ComparePlot : public ChartPlot {
    Q_OBJECT
public:
    explicit ComparePlot(QWidget* parent = nullptr);

    /// The current run first; keeps the visible range unless it was the whole. No replot. Returns
    /// whether the unit of the horizontal axis changed.
    bool setRuns(std::vector<ComparedFeeds> runs);
    void setAxis(CycleAxis axis); ///< shows all
    /// Sets the quantity of a row's right axis and shows all of its values.
    void setSecond(std::size_t row, Quantity quantity);
    [[nodiscard]] Quantity secondQuantity(std::size_t row) const { return m_chart.second(row); }
    void setMoment(std::optional<double> time_s); ///< for the current run
    void fit() override;

    /// Within a plot, wheel and drag move only the time.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const std::vector<ComparedFeeds>& runs() const { return m_chart.runs(); }
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] LegendEntries legendEntries() const override; ///< quantities and runs
    [[nodiscard]] CursorSubject cursorSubject() override;

signals:
    void timeClicked(double time_s); ///< for the current run

private:
    void showChoice() override { setTexts(); }
    [[nodiscard]] LegendEntries besides(int key) const override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    [[nodiscard]] std::size_t otherRunAt(const QPointF& at) const;

    CompareChart m_chart;
    HairLine* m_momentLine;
    HairLine* m_hairLine;
    std::optional<double> m_moment_s;
    PlotHistory::State m_fitted; ///< last shown by fit()
};

} // namespace sparkout
