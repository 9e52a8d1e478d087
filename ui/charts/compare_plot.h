// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/plot_history.h"
#include "ui/plot/read_curves.h"
#include "ui/plot/view_plot.h"
#include "ui/tables/csv_table.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

class HairLine;
struct CursorSubject;

/// A run whose curves are drawn: of one of its zones or sections.
struct ComparedFeeds {
    QString name; ///< for the legend
    std::shared_ptr<const FeedSeries> feeds;
    std::size_t column = 0;
    int number = 0; ///< chooses the dash; 0: the present run
};

/// Actual over accumulated feed of several runs, double stroke by double stroke, over one
/// horizontal axis; each with a second quantity on an axis to the right, force and radius unless
/// chosen otherwise. The colour says which quantity, the dash which run.
class ComparePlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr std::size_t rowCount = 2;
    /// What the right-hand axes can show, row by row; the first unless chosen.
    static constexpr std::array<std::array<Quantity, 3>, rowCount> secondQuantities{
        {{Quantity::force, Quantity::programmed, Quantity::axialFeed},
         {Quantity::left, Quantity::came, Quantity::programmedSum}}};
    static constexpr int runKey = 100; ///< of the legend, plus the number; below: a Quantity

    explicit ComparePlot(QWidget* parent = nullptr);

    /// The present run first; what is in sight stays unless all was. No replot.
    void setRuns(std::vector<ComparedFeeds> runs);
    void setAxis(CycleAxis axis); ///< shows all
    /// On the right-hand axis of a row, in its place; shows all of its values.
    void setSecond(std::size_t row, Quantity quantity);
    [[nodiscard]] Quantity second(std::size_t row) const { return m_second.at(row); }
    [[nodiscard]] std::array<Quantity, 4> quantities() const; ///< left and right, row by row
    void setMoment(std::optional<double> time_s);             ///< of the present run
    void fit();
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    /// Within a plot, wheel and drag move the time only.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const std::vector<ComparedFeeds>& runs() const { return m_runs; }
    [[nodiscard]] QCPAxis* axisOf(Quantity quantity) const; ///< of a quantity that is drawn
    [[nodiscard]] QCPGraph* curve(int number, Quantity quantity) const; ///< null: no such run
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] QString timeLabel() const; ///< "Time, min"
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] ReadCurves readCurves() const; ///< the shown ones, run by run
    [[nodiscard]] CursorSubject cursorSubject();
    [[nodiscard]] CsvTable table() const; ///< the visible curves' points within the visible span

signals:
    void timeClicked(double time_s); ///< of the present run

private:
    void setTexts() override;
    void pointAway() override;
    struct Curve {
        std::size_t run; ///< index in m_runs
        Quantity quantity;
        QCPGraph* graph;
    };
    void build();
    void fitTexts();
    void fitValues(Quantity quantity);
    [[nodiscard]] QColor colourOf(Quantity quantity) const;
    [[nodiscard]] const FeedPoints& pointsOf(const ComparedFeeds& run) const;
    void fill();
    void showCurves();
    void labelAxes();
    [[nodiscard]] static QString briefName(Quantity quantity);
    void onMouse(QMouseEvent* event);
    [[nodiscard]] const Curve* nearestCurve(const QPointF& at) const;
    [[nodiscard]] QString values(std::size_t run, double x) const;
    [[nodiscard]] QString shortName(std::size_t run) const;
    [[nodiscard]] double end() const; ///< of the longest run
    [[nodiscard]] PlotHistory::State ranges() const;
    [[nodiscard]] const CycleScale& presentScale() const { return m_scales.front(); }

    std::vector<ComparedFeeds> m_runs;
    std::vector<CycleScale> m_scales; ///< of each run
    std::vector<Curve> m_curves;
    CurveChoice m_choice;
    CycleAxis m_axis = CycleAxis::minutes;
    std::array<Quantity, rowCount> m_second{secondQuantities[0][0], secondQuantities[1][0]};
    std::array<QCPAxisRect*, rowCount> m_rects{};
    HairLine* m_hairLine = nullptr;
    HairLine* m_momentLine = nullptr;
    std::optional<double> m_moment_s;
    PlotHistory::State m_fitted; ///< what fit() showed
};

} // namespace sparkout
