// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/chart_plot.h"
#include "ui/session/studies.h"
#include "ui/text/time_unit.h"

#include <optional>

namespace sparkout {

/// What a cycle takes and how far it is from its nearest limit.
struct TimedMargin {
    double time_s = 0;
    double leastRelativeMargin = 0;
};

/// Time against margin: the cycles of the grid of which none is both as quick and as far from its
/// nearest limit as another, as a step curve: what margin a time buys. With the cycle compared
/// with, the one chosen and the time that a search for the greatest margin leaves. A click or
/// the arrow keys choose a cycle, Enter takes it.
class MarginFrontPlot : public ChartPlot {
    Q_OBJECT
public:
    enum Key { frontKey, yoursKey, chosenKey, timeKey }; ///< of the legend

    explicit MarginFrontPlot(QWidget* parent = nullptr);

    /// No replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<TimedMargin> yours);
    void setChosen(const FoundCycle* found); ///< of the outcome; null: none; no replot
    /// Whether there is a curve.
    [[nodiscard]] bool hasFront() const { return !front().empty(); }

    PlotTools& addTools(PlotSubject subject, Settings* settings) override;
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);

signals:
    void cycleClicked(std::size_t row); ///< of the outcome's cycles found
    void cyclePointed(std::size_t row); ///< the same by a key, which stays here
    void cycleEntered();                ///< the chosen one is to be taken

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< of its own keys

private:
    [[nodiscard]] LineChart made() const;
    [[nodiscard]] std::vector<const FoundCycle*> front() const; ///< the quickest first
    [[nodiscard]] XY placeOf(const TimedMargin& of) const;
    [[nodiscard]] bool onKey(int key);
    /// The next of the front that takes longer than the chosen one, or less; null: none.
    [[nodiscard]] const FoundCycle* beside(bool isLonger) const;
    [[nodiscard]] QString described(const FoundCycle& found) const;
    [[nodiscard]] std::size_t rowOf(const FoundCycle& found) const;
    [[nodiscard]] std::optional<double> given_s() const;

    SearchOutcomePtr m_outcome;
    std::optional<TimedMargin> m_own, m_chosen;
    TimeUnit m_unit; ///< of the longest time shown
};

} // namespace sparkout
