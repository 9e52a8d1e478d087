// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"
#include "ui/views/feed_series.h"
#include "ui/views/legend_strip.h"

#include <qcustomplot.h>

#include <array>
#include <memory>
#include <vector>

namespace sparkout {

class BandLayer;
struct Band;

/// The grid of plots of the view "Feeds by stage": a column a zone or section; rows of feed,
/// accumulated feed with radii, and axial feed or normal force. All columns are linked in x, each
/// row in y. Wheel zooms, drag pans (time only; over a vertical axis that axis), double click fits.
class FeedsPlot : public QCustomPlot {
    Q_OBJECT
public:
    /// What a point of the curves stands for, by how much is in sight.
    enum class Detail { stroke, pass, radius };
    static constexpr int rowCount = 3;

    explicit FeedsPlot(QWidget* parent = nullptr);

    /// Shows a run; the visible range is kept unless it lies outside. No replot.
    void setRun(OutcomePtr outcome, FeedSeries series);
    void setAxis(CycleAxis axis);
    void setDimmed(bool dim);
    void showTimes(double from_s, double to_s); ///< no replot
    void fitValues() { m_ownValues = {}; }      ///< from the next showTimes() on
    void showAll() { showTimes(0, m_series.end_s); }
    void retranslate();
    void restyle();

    [[nodiscard]] const FeedSeries& series() const { return m_series; }
    [[nodiscard]] double visibleFrom_s() const { return m_from_s; }
    [[nodiscard]] double visibleTo_s() const { return m_to_s; }
    [[nodiscard]] Detail detail() const { return m_detail; }
    [[nodiscard]] std::vector<LegendEntry> legendEntries() const;
    [[nodiscard]] BandLayer* bands(int column, int row) const;
    [[nodiscard]] QCPAxisRect* cell(int column, int row) const;
    [[nodiscard]] QCPGraph* curve(int column, Quantity quantity, Edge edge) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 260}; }

signals:
    void movedByUser();                    ///< zoomed or panned with the mouse
    void fitAsked();                       ///< double click
    void contentChanged();                 ///< detail or bands, hence the legend
    void pointed(const QString& text);     ///< values under the mouse, empty outside
    void pointedBand(const QString& text); ///< full name of the band under the mouse

protected:
    void resizeEvent(QResizeEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Curve {
        Quantity quantity;
        Edge edge;
        QCPGraph* graph;
    };
    struct Column {
        QCPTextElement* header = nullptr;
        std::array<QCPAxisRect*, rowCount> rects{};
        std::array<BandLayer*, rowCount> bands{};
        std::vector<Curve> curves;
        FeedPoints points; ///< what is drawn now
    };
    void buildGrid();
    void buildCell(Column& column, int row, int index);
    void setUpAxes(QCPAxisRect* rect, int row, bool first, bool last);
    void addRow(Column& column, int row);
    void addCurves(Column& column, Quantity quantity, QCPAxis* value, bool band);
    void linkAxes();
    void labelAxes();
    void fitHeaders();
    void onTimesChanged(const QCPRange& range);
    void onValuesChanged(QCPAxis* axis, const QCPRange& range);
    void refresh();
    void chooseDetail();
    void fillColumn(std::size_t index);
    void fillBands(std::size_t index);
    void scaleValues();
    [[nodiscard]] QCPRange valuesOf(std::initializer_list<Quantity> quantities) const;
    void stylePens(Column& column);
    [[nodiscard]] QColor colourOf(Quantity quantity) const;
    [[nodiscard]] QColor colourOf(Zone zone, Step step) const;
    [[nodiscard]] std::vector<Band> stepBands(const FeedColumn& column) const;
    [[nodiscard]] std::vector<Band> stageBands() const;
    [[nodiscard]] bool showsSteps() const;
    void onWheel(QWheelEvent* event);
    void onMouse(QMouseEvent* event);
    [[nodiscard]] double visibleStrokes() const {
        return m_strokes.at(m_to_s) - m_strokes.at(m_from_s);
    }

    OutcomePtr m_outcome;
    FeedSeries m_series;
    CycleAxis m_axis = CycleAxis::minutes;
    CycleScale m_scale;
    CycleScale m_strokes; ///< counts the double strokes in sight
    std::vector<Column> m_columns;
    double m_from_s = 0, m_to_s = 0;
    Detail m_detail = Detail::stroke;
    bool m_stepsShown = false;
    bool m_dim = false;
    bool m_linking = false;
    std::array<bool, rowCount> m_ownValues{}; ///< the user zoomed this row's values
};

} // namespace sparkout
