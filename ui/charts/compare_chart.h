// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "ui/tables/csv_table.h"

#include <QCoreApplication>

#include <array>
#include <functional>
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
/// quantity on the left and one on the right: the data for drawing, reading and tables.
class CompareChart {
    Q_DECLARE_TR_FUNCTIONS(CompareChart)
public:
    static constexpr std::size_t rowCount = 2;
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
    [[nodiscard]] std::vector<XY> line(std::size_t run, Quantity quantity) const;
    [[nodiscard]] double end() const;        ///< end of the longest run on the axis
    [[nodiscard]] QString timeLabel() const; ///< "Time, min"
    [[nodiscard]] static QString briefName(Quantity quantity); ///< for an axis, since plots are low
    [[nodiscard]] QStringList shortNames() const;              ///< unique short names of the runs
    /// The values of a run at a place of the axis, on one line.
    [[nodiscard]] QString valuesAt(std::size_t run, double x) const;
    /// The points within a range of the axis, for the requested runs and quantities.
    [[nodiscard]] CsvTable table(double from, double to,
                                 const std::function<bool(const ComparedFeeds&)>& wanted,
                                 const std::function<bool(Quantity)>& shown) const;

private:
    [[nodiscard]] const FeedPoints& pointsOf(std::size_t run) const;
    [[nodiscard]] QString shortName(std::size_t run) const;
    [[nodiscard]] double longest_s() const; ///< time of the longest run

    std::vector<ComparedFeeds> m_runs;
    std::vector<CycleScale> m_scales; ///< scale of each run
    CycleAxis m_axis = CycleAxis::time;
    std::array<Quantity, rowCount> m_second{secondQuantities[0][0], secondQuantities[1][0]};
};

} // namespace sparkout
