// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
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
class MarginFrontPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { frontKey, yoursKey, chosenKey, timeKey }; ///< of the legend

    explicit MarginFrontPlot(QWidget* parent = nullptr);

    /// No replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<TimedMargin> yours);
    void setChosen(const FoundCycle* found); ///< of the outcome; null: none; no replot
    /// Whether there is a curve.
    [[nodiscard]] bool hasFront() const { return m_curve->dataCount() > 0; }
    /// Where the n-th cycle of the front is drawn.
    [[nodiscard]] QPointF pixelOf(std::size_t n) const;
    [[nodiscard]] QCPGraph* curve() const { return m_curve; }
    [[nodiscard]] QCPGraph* yours() const { return m_yours; }
    [[nodiscard]] QCPGraph* chosen() const { return m_chosen; }
    [[nodiscard]] QCPItemStraightLine* givenTime() const { return m_time; }

    PlotTools& addTools(PlotSubject subject, Settings* settings) override;
    void fit() override;
    void restyle() override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the cycles in sight
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);

signals:
    void cycleClicked(std::size_t row); ///< of the outcome's cycles found
    void cyclePointed(std::size_t row); ///< the same by a key, which stays here
    void cycleEntered();                ///< the chosen one is to be taken

protected:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    bool eventFilter(QObject* watched, QEvent* event) override; ///< of its own keys

private:
    [[nodiscard]] bool onKey(int key);
    /// The next of the front that takes longer than the chosen one, or less; null: none.
    [[nodiscard]] const FoundCycle* beside(bool isLonger) const;
    [[nodiscard]] QString described(const FoundCycle& found) const;
    void fill();
    [[nodiscard]] double longest_s() const; ///< of the times that are shown
    void showTime();
    [[nodiscard]] const FoundCycle* cycleAt(const QPointF& at) const;
    [[nodiscard]] std::size_t rowOf(const FoundCycle& found) const;
    [[nodiscard]] bool showsTime() const { return m_outcome && m_outcome->marginWithin_us; }
    [[nodiscard]] QCPAxis* across() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* up() const { return m_rect->axis(QCPAxis::atLeft); }

    SearchOutcomePtr m_outcome;
    std::optional<TimedMargin> m_own;
    TimeUnit m_unit;
    std::optional<double> m_chosen_s; ///< time of the chosen one
    QCPAxisRect* m_rect;
    QCPGraph *m_curve, *m_yours, *m_chosen;
    QCPItemStraightLine* m_time;
};

} // namespace sparkout
