// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_data.h"
#include "core/study/outcome.h"
#include "ui/session/job.h"
#include "ui/views/cycle/feeds_plot.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace sparkout {

using TraceComparisonsPtr = std::shared_ptr<const std::vector<TraceComparison>>;

/// Compares the traces of a project with its run on another thread; a newer run replaces the older
/// one.
class TraceComparer : public QObject {
    Q_OBJECT

public:
    explicit TraceComparer(QObject* parent = nullptr);

    void compare(const OutcomePtr& outcome);
    void drop(); ///< discards a running comparison
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void compared(sparkout::TraceComparisonsPtr traces, sparkout::OutcomePtr of);

private:
    bool m_running = false;
    NewestJob m_job; ///< last member: stopped before the objects it reports to are destroyed
};

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
