// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/line_chart.h"

#include <QCoreApplication>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// A run to be drawn, with one of its zones or sections.
struct ComparedFeeds {
    QString name; ///< for the legend
    std::shared_ptr<const FeedSeries> feeds;
    std::size_t column = 0;
    int number = 0; ///< index of the dash; 0: the current run
};

/// The feeds of several runs over one horizontal axis, the current run first, in two plots with a
/// quantity on the left and one on the right. The colour identifies the quantity, the dash the run.
class CompareChart {
    Q_DECLARE_TR_FUNCTIONS(CompareChart)
public:
    static constexpr std::size_t rowCount = 2;
    static constexpr int runKey = 100; ///< in the legend, plus the number; below: a Quantity
    /// The possible quantities of the right axes, by row; the first is the default.
    static constexpr std::array<std::array<Quantity, 3>, rowCount> secondQuantities{
        {{Quantity::force, Quantity::programmed, Quantity::axialFeed},
         {Quantity::left, Quantity::came, Quantity::programmedSum}}};

    void setRuns(std::vector<ComparedFeeds> runs);
    void setAxis(CycleAxis axis);
    void setSecond(std::size_t row, Quantity quantity) { m_second.at(row) = quantity; }

    [[nodiscard]] const std::vector<ComparedFeeds>& runs() const { return m_runs; }
    [[nodiscard]] const CycleScale& scale(std::size_t run) const { return m_scales[run]; }
    [[nodiscard]] Quantity second(std::size_t row) const { return m_second.at(row); }
    [[nodiscard]] std::array<Quantity, 4> quantities() const; ///< left and right, by row
    [[nodiscard]] QString timeLabel() const;                  ///< "Time, min"
    /// The values of a run at a place of the axis, on one line.
    [[nodiscard]] QString valuesAt(std::size_t run, double x) const;
    /// A cell for each row. In each, two series a run, the current run last and hence on top; those
    /// of a hidden run have no points. All runs count for the values in sight.
    [[nodiscard]] ChartGrid grid(const CurveChoice& choice) const;

private:
    [[nodiscard]] LineChart cell(std::size_t row, const CurveChoice& choice) const;
    [[nodiscard]] ChartTable table(const CurveChoice& choice) const; ///< shown runs and quantities
    [[nodiscard]] const FeedPoints& pointsOf(std::size_t run) const;
    [[nodiscard]] double end() const; ///< end of the longest run on the axis
    [[nodiscard]] static QString briefName(Quantity quantity); ///< for an axis, since plots are low
    [[nodiscard]] QStringList shortNames() const;              ///< unique short names of the runs
    [[nodiscard]] QString shortName(std::size_t run) const;
    [[nodiscard]] double longest_s() const; ///< time of the longest run

    std::vector<ComparedFeeds> m_runs;
    std::vector<CycleScale> m_scales; ///< scale of each run
    CycleAxis m_axis = CycleAxis::time;
    std::array<Quantity, rowCount> m_second{secondQuantities[0][0], secondQuantities[1][0]};
};

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
