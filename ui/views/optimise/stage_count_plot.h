// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/session/search_runner.h"

#include <array>
#include <optional>

namespace sparkout {

/// The time of the quickest cycle over its number of stages, above the stepless limit and beside
/// the time of the cycle compared with. Where a search was stopped also the time that none is
/// below.
class StageCountPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { quickest, proven, before, limit };

    explicit StageCountPlot(QWidget* parent = nullptr);

    /// No replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<double> before_s);
    void fit() override;
    void restyle() override;

    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);
    [[nodiscard]] QCPGraph* curve(Key key) const { return m_curves[key]; }

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void fill();
    [[nodiscard]] static QString name(Key key);

    SearchOutcomePtr m_outcome;
    std::optional<double> m_before_s;
    QCPAxisRect* m_rect = nullptr;
    std::array<QCPGraph*, 4> m_curves{}; ///< by Key
};

} // namespace sparkout
