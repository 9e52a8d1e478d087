// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/bars/bar_plot.h"
#include "ui/session/studies.h"

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

} // namespace sparkout
