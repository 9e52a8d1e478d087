// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/chart_plot.h"
#include "ui/views/constraints/limit_chart.h"

#include <optional>

namespace sparkout {

class HairLine;

/// The actual feed of one zone or section over the stock left, below the curves of all limits that
/// are on, with the names of those that bind and a text beside the marked cut.
class ConstraintsPlot : public ChartPlot {
    Q_OBJECT
public:
    explicit ConstraintsPlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome, int group); ///< no replot
    void setLogarithmic(bool on);
    /// Marks the worst place of a requirement; empty: the place where the group is nearest to its
    /// limit.
    void setMarked(const std::optional<ConstraintResult>& requirement);
    void setMoment(std::optional<double> stock_mm); ///< stock at the moment of the cycle
    void fit() override;
    void fitNext() { m_fitNext = true; } ///< the next run is of another part

    [[nodiscard]] int group() const { return m_limits.group(); }
    [[nodiscard]] const LimitChart& limits() const { return m_limits; }
    [[nodiscard]] std::optional<double> moment_um() const; ///< stock of the moment's line
    /// The text beside the mark in the last replot; empty if there is none.
    [[nodiscard]] QRectF callOut() const;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the visible cuts

private:
    class Labels;
    void refit();

    LimitChart m_limits;
    Labels* m_labels;
    HairLine* m_moment;
    bool m_isLogarithmic = false;
    QCPRange m_fittedStock; ///< axis range of the last fit
    QCPRange m_fittedFeeds; ///< axis range of the last fit
    bool m_fitNext = false;
};

} // namespace sparkout
