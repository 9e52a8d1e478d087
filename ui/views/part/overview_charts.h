// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/adequacy.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "ui/chart/bar_chart.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

/// The charts of the view "Overview", in the order of the page.
enum class OverviewChart {
    times,        ///< by stage and step
    stock,        ///< removed stock by stage, zone and step
    diameters,    ///< parts of the deviations
    requirements, ///< usage of each limit
    boxes,        ///< the batch by zone
    parts,        ///< good and rejected parts of the batch
    runs,         ///< kept runs and the current one
};
inline constexpr std::array allOverviewCharts{OverviewChart::times,     OverviewChart::stock,
                                              OverviewChart::diameters, OverviewChart::requirements,
                                              OverviewChart::boxes,     OverviewChart::parts,
                                              OverviewChart::runs};

/// The bars of a run; values are empty if unknown.
struct RunBars {
    QString name;
    std::optional<double> time_min = {};
    std::optional<ConstraintResult> least = {}; ///< the requirement with the minimum margin
};

/// The content of the view "Overview" as values, also drawn in the passport. A chart without data
/// is empty.
class OverviewCharts {
    Q_DECLARE_TR_FUNCTIONS(OverviewCharts)
public:
    static QString title(OverviewChart chart);

    static BarChart times(const Outcome& outcome);
    static BarChart stock(const Outcome& outcome);
    static BarChart diameters(const Outcome& outcome);
    static BarChart requirements(const Outcome& outcome);
    /// Draws measured diameters beside the predicted ones.
    static BarChart boxes(const BatchOutcome& batch,
                          const std::vector<MeasuredStatistics>& measured = {});
    static BarChart parts(const BatchOutcome& batch);
    /// `kept` is the number of all kept runs.
    static BarChart runs(const std::vector<RunBars>& runs, int kept);

    /// The objects of a chart's bars by category: a stage or a section, counted from 0, or a
    /// requirement.
    static std::vector<std::size_t> stagesShown(const Outcome& outcome);
    static std::vector<int> sectionsOfDiameters(const Outcome& outcome);
    static std::vector<ConstraintResult> requirementsShown(const Outcome& outcome);

    static constexpr int mostRuns = 8;            ///< greatest number of kept runs, the newest ones
    static constexpr std::size_t mostStages = 24; ///< of stages, those that take longest

private:
    static std::vector<BarSeries> stepSeries(const Outcome& outcome);
    static QString stagesRemark(const Outcome& outcome);
    static QString sectionsRemark(const Outcome& outcome);
    /// The name of a zone, or the number of a section.
    static QString briefPlace(const Outcome& outcome, int section);
};

} // namespace sparkout
