// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"
#include "ui/plot/view_plot.h"
#include "ui/views/feeds/trace_comparer.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

class HairLine;

/// The fourth row of the view "Feeds by stage": measurements over the time of a cycle, a cell for
/// each quantity, with the simulated curve and, on the right axis, their difference. Its times
/// follow the feeds above it.
class TracesPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { measuredKey = 300, simulatedKey, differenceKey }; ///< keys of the legend

    explicit TracesPlot(QWidget* parent = nullptr);

    void setTraces(TraceComparisonsPtr traces, const Project& project); ///< null: none; no replot
    [[nodiscard]] bool isEmpty() const { return m_cells.empty(); }
    /// Sets the visible range, that of the feeds; no replot.
    void showTimes(const CycleScale& scale, double from_s, double to_s, const QString& timeLabel);
    void setEnd(double end_s) { m_end_s = end_s; } ///< end of the cycle
    void setMoment(std::optional<double> time_s);  ///< moment of the cycle

    [[nodiscard]] std::size_t cellCount() const { return m_cells.size(); }
    [[nodiscard]] QCPAxisRect* cell(std::size_t index) const { return m_cells.at(index).rect; }
    [[nodiscard]] QString heading(std::size_t index) const; ///< heading of a cell, with its RMS
    [[nodiscard]] QCPGraph* curve(std::size_t cell, Key key) const; ///< curve of its first trace

    void fit() override { emit fitWanted(); }
    void restyle() override;
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] CursorSubject cursorSubject() override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void timesWanted(double from_s, double to_s);
    void fitWanted();
    void timeClicked(double time_s);

protected:
    void setTexts() override;
    void takeLook(bool font) override;
    void showChoice() override;
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    struct Lines {
        const TraceComparison* trace;
        std::array<QCPGraph*, 3> graphs; ///< measured, simulated, difference
    };
    /// All traces of one quantity at one place.
    struct Cell {
        FitSource source;
        std::optional<int> place;
        QCPTextElement* header;
        QCPAxisRect* rect;
        std::vector<Lines> lines;
    };
    void build();
    void addCell(const TraceComparison& trace);
    void fill();
    void scaleValues();
    void label();
    void afterLayouting();
    [[nodiscard]] QString nameOf(const Cell& cell) const;
    [[nodiscard]] double rmsOf(const Cell& cell) const;
    [[nodiscard]] const Cell* cellAt(const QPointF& at) const;
    [[nodiscard]] int columns() const; ///< cells side by side

    TraceComparisonsPtr m_traces;
    bool m_hasZones = false;
    std::vector<Cell> m_cells;
    CycleScale m_scale;
    QString m_timeLabel;
    double m_from_s = 0, m_to_s = 0, m_end_s = 0;
    bool m_linking = false;
    HairLine* m_momentLine;
    HairLine* m_hairLine;
    std::optional<double> m_moment_s;
};

} // namespace sparkout
