// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

#include <array>
#include <memory>
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

} // namespace sparkout
