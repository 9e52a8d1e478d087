// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_plot.h"
#include "ui/chart/chart_plot.h"
#include "ui/session/studies.h"
#include "ui/text/number_text.h"

#include <optional>

namespace sparkout {

/// The time of the quickest cycle by its number of stages, as bars, with the stepless limit and the
/// time of the reference cycle. After a stop it also shows the lower bound of the time.
class StageCountPlot : public BarPlot {
    Q_OBJECT
public:
    explicit StageCountPlot(QWidget* parent = nullptr);

    /// Sets the content without a replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<double> before_s);
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);

protected:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    [[nodiscard]] BarChart makeChart() const;

    SearchOutcomePtr m_outcome;
    std::optional<double> m_before_s;
};

/// The time of a cycle and its distance from its nearest limit.
struct TimedMargin {
    double time_s = 0;
    double leastRelativeMargin = 0;
};

/// Time against margin: the cycles of the grid for which no other is both as quick and as far from
/// its nearest limit, as a step curve that shows the margin for a time. Also shows the reference
/// cycle, the chosen one and the time allowed in a search for the greatest margin. A click or the
/// arrow keys choose a cycle, Enter takes it.
class MarginFrontPlot : public ChartPlot {
    Q_OBJECT
public:
    enum Key { frontKey, yoursKey, chosenKey, timeKey }; ///< keys of the legend

    explicit MarginFrontPlot(QWidget* parent = nullptr);

    /// Sets the content without a replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<TimedMargin> yours);
    void setChosen(const FoundCycle* found); ///< a cycle of the outcome, or null; no replot
    /// Whether there is a front to draw.
    [[nodiscard]] bool hasFront() const { return !front().empty(); }

    PlotTools& addTools(PlotSubject subject, Settings* settings) override;
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);

signals:
    void cycleClicked(std::size_t row); ///< index in the outcome's list of found cycles
    void cyclePointed(std::size_t row); ///< chosen by a key, so the plot keeps the focus
    void cycleEntered();                ///< requests to take the chosen cycle

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< handles its own keys

private:
    [[nodiscard]] LineChart made() const;
    [[nodiscard]] std::vector<const FoundCycle*> front() const; ///< the quickest first
    [[nodiscard]] XY placeOf(const TimedMargin& of) const;
    [[nodiscard]] bool onKey(int key);
    /// The neighbour of the chosen cycle in the front with a longer, or a shorter, time; null if
    /// there is none.
    [[nodiscard]] const FoundCycle* beside(bool isLonger) const;
    [[nodiscard]] QString described(const FoundCycle& found) const;
    [[nodiscard]] std::size_t rowOf(const FoundCycle& found) const;
    [[nodiscard]] std::optional<double> given_s() const;

    SearchOutcomePtr m_outcome;
    std::optional<TimedMargin> m_own, m_chosen;
    TimeUnit m_unit; ///< unit for the longest time shown
};

} // namespace sparkout
