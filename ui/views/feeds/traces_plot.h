// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/feeds/cycle_plot.h"
#include "ui/views/feeds/trace_comparer.h"

#include <QString>

namespace sparkout {

/// The fourth row of the view "Feeds by stage": measurements over the time of a cycle, a cell for
/// each quantity, with the simulated curve and, on the right axis, their difference. Its times
/// follow the feeds above it.
class TracesPlot : public CyclePlot {
    Q_OBJECT
public:
    enum Key { measuredKey = 300, simulatedKey, differenceKey }; ///< keys of the legend

    explicit TracesPlot(QWidget* parent = nullptr);

    void setTraces(TraceComparisonsPtr traces, const Project& project); ///< null: none; no replot
    [[nodiscard]] bool isEmpty() const { return cellCount() == 0; }
    /// Sets the visible range, that of the feeds; no replot.
    void showTimes(const CycleTimes& times, const QString& timeLabel);

    [[nodiscard]] const CycleTimes& times() const override { return m_times; }
    [[nodiscard]] QString timeLabel() const override { return m_timeLabel; }
    void fit() override { emit fitWanted(); }
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void fitWanted();

protected:
    void takeLook(bool font) override;

private:
    /// All traces of one quantity at one place.
    using Group = std::vector<const TraceComparison*>;
    [[nodiscard]] std::vector<Group> groups() const;
    [[nodiscard]] ChartGrid made() const;
    [[nodiscard]] LineChart chartOf(const Group& group) const;
    [[nodiscard]] bool isInSight(double time_s) const;
    [[nodiscard]] CsvTable tableOf() const;
    [[nodiscard]] QString nameOf(const TraceComparison& trace) const;
    [[nodiscard]] QString textAt(const TraceComparison& trace,
                                 const std::vector<ChartReading>& readings, double x) const;

    TraceComparisonsPtr m_traces;
    bool m_hasZones = false;
    CycleTimes m_times;
    QString m_timeLabel;
};

} // namespace sparkout
