// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "core/study/outcome.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/plot_history.h"
#include "ui/plot/read_curves.h"
#include "ui/plot/view_plot.h"
#include "ui/tables/csv_table.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

class BandLayer;
class HairLine;
struct CursorSubject;
struct Band;

/// The grid of plots of the view "Feeds by stage": a column a zone or section; rows of feed,
/// accumulated feed with radii, and axial feed with normal force. All columns are linked in x, each
/// row in y.
class FeedsPlot : public ViewPlot {
    Q_OBJECT
public:
    /// What a point of the curves stands for, by how much is in sight.
    enum class Detail { stroke, pass, radius };
    static constexpr int rowCount = 3;
    static constexpr int spreadKey = 100; ///< of the legend; below: a Quantity

    explicit FeedsPlot(QWidget* parent = nullptr);

    /// Shows columns of a run; the visible range is kept unless it lies outside. No replot.
    void setRun(OutcomePtr outcome, const std::vector<int>& shown);
    void setAxis(CycleAxis axis);
    void setMoment(std::optional<double> time_s); ///< where the cycle stands; nothing: at its end
    void showTimes(double from_s, double to_s);   ///< no replot
    void fitValues() { m_values = {}; }           ///< from the next showTimes() on
    void showAll() { showTimes(0, series().end_s); }
    void fit() override {
        fitValues();
        showAll();
    }
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    /// What is in sight, for the history.
    [[nodiscard]] PlotHistory::State sight() const;
    void setSight(const PlotHistory::State& state);
    /// Within a plot, wheel and drag move the time only.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;

    [[nodiscard]] const FeedSeries& series() const;
    [[nodiscard]] int columnCount() const { return static_cast<int>(m_columns.size()); }
    [[nodiscard]] const FeedColumn& source(int column) const;
    [[nodiscard]] const CycleScale& scale() const { return m_scale; }
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    [[nodiscard]] double visibleFrom_s() const { return m_from_s; }
    [[nodiscard]] double visibleTo_s() const { return m_to_s; }
    [[nodiscard]] Detail detail() const { return m_detail; }
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] CsvTable table() const; ///< the visible curves' points within the visible span
    /// The shown curves, without their spread.
    [[nodiscard]] ReadCurves readCurves() const;
    [[nodiscard]] CursorSubject cursorSubject();
    [[nodiscard]] BandLayer* bands(int column, int row) const;
    [[nodiscard]] QCPAxisRect* cell(int column, int row) const;
    [[nodiscard]] QCPGraph* curve(int column, Quantity quantity, Edge edge) const;
    [[nodiscard]] QString timeLabel() const; ///< "Time, min"
    [[nodiscard]] std::vector<Band> stageBands() const;
    [[nodiscard]] static QColor stepColour(Zone zone, Step step, const QPalette& palette);
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

signals:
    void timesChanged(); ///< other times are in sight
    void gridBuilt();    ///< all axes are new
    void timeClicked(double time_s);
    void pointedBand(const QString& text); ///< full name of the band under the mouse

protected:
    void setTexts() override;
    void takeLook(bool font) override;
    void pointAway() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Curve {
        Quantity quantity;
        Edge edge;
        QCPGraph* graph;
    };
    struct Column {
        std::size_t index = 0; ///< of its zone or section in the series
        QCPTextElement* header = nullptr;
        std::array<QCPAxisRect*, rowCount> rects{};
        std::array<BandLayer*, rowCount> bands{};
        std::vector<Curve> curves;
        FeedPoints points; ///< what is drawn now
    };
    /// The user's own ranges of a row's values.
    struct RowValues {
        bool own = false;
        QCPRange left, right;
    };
    void buildGrid(std::size_t columns);
    void buildCell(Column& column, int row, int index);
    void setUpAxes(QCPAxisRect* rect, int row, bool first, bool last);
    void addRow(Column& column, int row);
    void addCurves(Column& column, Quantity quantity, QCPAxis* value, bool band);
    void linkAxes();
    void labelAxes();
    void nameValueAxes(bool brief);
    [[nodiscard]] int longestAxisName() const;
    void fitValueAxes(int high);
    void fitColumns();
    [[nodiscard]] int alignLabels(QCPAxis::AxisType side, std::size_t column) const;
    void showHeaders(int plotWidth, int left, int right);
    void onTimesChanged(const QCPRange& range);
    void onValuesChanged(QCPAxis* axis, const QCPRange& range);
    void refresh();
    void chooseDetail();
    void fillColumn(Column& column);
    [[nodiscard]] FeedPoints pointsOf(const FeedColumn& column, Detail detail, double from_s,
                                      double to_s) const;
    [[nodiscard]] std::optional<double> readValue(const FeedColumn& column, Quantity quantity,
                                                  double x) const;
    void fillBands();
    void showCurves();
    void scaleValues();
    [[nodiscard]] QCPRange valuesOf(std::initializer_list<Quantity> quantities) const;
    void stylePens(Column& column);
    [[nodiscard]] QColor colourOf(Quantity quantity) const;
    [[nodiscard]] bool shows(Quantity quantity) const { return m_choice.shows(keyOf(quantity)); }
    /// A feed and its sum are one entry of the legend.
    [[nodiscard]] static int keyOf(Quantity quantity);
    [[nodiscard]] std::vector<Band> stepBands(const FeedColumn& column) const;
    [[nodiscard]] bool showsSteps() const;
    [[nodiscard]] std::vector<std::pair<Zone, Step>> stepsInSight() const;
    [[nodiscard]] bool countsStrokes() const { return series().operation->countsStrokes; }
    [[nodiscard]] bool hasAxialFeed() const { return series().operation->axial() != nullptr; }
    void onMouse(QMouseEvent* event);
    [[nodiscard]] double visibleStrokes() const {
        return m_strokes.at(m_to_s) - m_strokes.at(m_from_s);
    }

    OutcomePtr m_outcome;
    CycleAxis m_axis = CycleAxis::minutes;
    CycleScale m_scale;
    CycleScale m_strokes; ///< counts the double strokes in sight
    QCPLayoutGrid* m_grid = nullptr;
    QCPTextElement* m_timeLabel = nullptr;
    HairLine* m_hairLine = nullptr;
    HairLine* m_momentLine = nullptr;
    std::optional<double> m_moment_s;
    std::vector<Column> m_columns;
    CurveChoice m_choice;
    double m_from_s = 0, m_to_s = 0;
    Detail m_detail = Detail::stroke;
    std::vector<std::pair<Zone, Step>> m_steps; ///< in sight, one of each colour
    bool m_linking = false;
    std::array<RowValues, rowCount> m_values{};
};

} // namespace sparkout
