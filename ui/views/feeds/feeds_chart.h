// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "core/study/outcome.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"

#include <QCoreApplication>

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// The feeds of a run as data for drawing, reading and tables: some of its zones or sections, over
/// one of the axes, within the visible times.
class FeedsChart {
    Q_DECLARE_TR_FUNCTIONS(FeedsChart)
public:
    /// The meaning of a point of the curves, by the visible range.
    enum class Detail { stroke, pass, radius };
    using Steps = std::vector<std::pair<Zone, Step>>;
    static constexpr int spreadKey = 100; ///< key of the legend; lower ones: a Quantity

    void setRun(OutcomePtr outcome, const std::vector<int>& shown);
    void setAxis(CycleAxis axis);
    void setTimes(double from_s, double to_s); ///< the visible range; requires setRun()

    [[nodiscard]] bool isEmpty() const { return m_columns.empty(); } ///< whether it has no run
    [[nodiscard]] const FeedSeries& series() const;
    [[nodiscard]] std::size_t columnCount() const { return m_columns.size(); }
    [[nodiscard]] const FeedColumn& source(std::size_t column) const;
    [[nodiscard]] const FeedPoints& points(std::size_t column) const; ///< within the times
    [[nodiscard]] const CycleScale& scale() const { return m_scale; }
    [[nodiscard]] double from_s() const { return m_from_s; }
    [[nodiscard]] double to_s() const { return m_to_s; }
    [[nodiscard]] Detail detail() const { return m_detail; }
    [[nodiscard]] bool showsSteps() const;                       ///< otherwise the stages are named
    [[nodiscard]] const Steps& steps() const { return m_steps; } ///< visible steps, each kind once
    [[nodiscard]] std::vector<StepSpan> stepsOf(std::size_t column) const;
    [[nodiscard]] bool countsStrokes() const { return series().operation->countsStrokes; }
    [[nodiscard]] bool hasAxialFeed() const { return series().operation->axial() != nullptr; }
    [[nodiscard]] QString timeLabel() const; ///< "Time, min"

    [[nodiscard]] static bool hasSpread(Quantity quantity);
    /// A feed and its sum share one entry of the legend.
    [[nodiscard]] static int keyOf(Quantity quantity);
    /// The points of a curve; radii have no spread.
    [[nodiscard]] std::vector<XY> line(std::size_t column, Quantity quantity, Edge edge) const;
    /// The extremes of the visible ones of these quantities; (0, 0) if there are none.
    [[nodiscard]] std::pair<double, double> extremes(std::initializer_list<Quantity> quantities,
                                                     const CurveChoice& choice) const;
    /// A readable curve, also outside the visible range.
    [[nodiscard]] ReadCurve readCurve(std::size_t column, Quantity quantity) const;
    [[nodiscard]] CsvTable table(const CurveChoice& choice) const;

private:
    struct Column {
        std::size_t index = 0; ///< index of its zone or section in the series
        FeedPoints points;     ///< drawn points …
        FeedPoints passes;     ///< … for the sums, where the points are radii
    };
    [[nodiscard]] double visibleStrokes() const {
        return m_strokes.at(m_to_s) - m_strokes.at(m_from_s);
    }
    [[nodiscard]] Detail visibleDetail() const;
    [[nodiscard]] Steps visibleSteps() const;
    /// Each radius has its own Σa, and joining them would give a saw-tooth. Mean and spread are per
    /// pass.
    [[nodiscard]] bool goesByPasses(Quantity quantity) const {
        return m_detail == Detail::radius && quantity == Quantity::actualSum;
    }
    [[nodiscard]] FeedPoints pointsOf(const FeedColumn& column, Detail detail, double from_s,
                                      double to_s) const;
    [[nodiscard]] std::vector<CsvCell> place(const FeedColumn& zone, const FeedPoint& point) const;

    OutcomePtr m_outcome;
    CycleAxis m_axis = CycleAxis::time;
    CycleScale m_scale;
    CycleScale m_strokes; ///< counts the visible double strokes
    std::vector<Column> m_columns;
    double m_from_s = 0, m_to_s = 0;
    Detail m_detail = Detail::stroke;
    Steps m_steps;
};

} // namespace sparkout
