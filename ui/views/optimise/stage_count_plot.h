// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"
#include "ui/plot/view_plot.h"
#include "ui/session/search_runner.h"
#include "ui/tables/csv_table.h"

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
    void fit();
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] CsvTable table() const;
    [[nodiscard]] static CsvTable tableOf(const SearchOutcome& outcome);
    [[nodiscard]] QCPGraph* curve(Key key) const { return m_curves[key]; }

private:
    void setTexts() override;
    void fill();
    void show();
    void onMouse(QMouseEvent* event);
    [[nodiscard]] static QString name(Key key);

    SearchOutcomePtr m_outcome;
    std::optional<double> m_before_s;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    std::array<QCPGraph*, 4> m_curves{}; ///< by Key
};

} // namespace sparkout
