// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/measured_statistics.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "ui/bars/bar_chart.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

/// The charts of the view "Overview", in the order of the page.
enum class OverviewChart {
    times,        ///< by stage and step
    stock,        ///< removed, by stage, zone and step
    diameters,    ///< what the deviations are made of
    requirements, ///< how much of its limit each uses up
    boxes,        ///< the batch by zone
    parts,        ///< of the batch, good and out
    runs,         ///< the kept ones beside the present one
};
inline constexpr std::array allOverviewCharts{OverviewChart::times,     OverviewChart::stock,
                                              OverviewChart::diameters, OverviewChart::requirements,
                                              OverviewChart::boxes,     OverviewChart::parts,
                                              OverviewChart::runs};

/// A run as its bars: each nothing where it is not known.
struct RunBars {
    QString name;
    std::optional<double> time_min, margin; ///< the margin as a share
};

/// What the view "Overview" draws, as values: the passport draws the same. A chart is empty where
/// there is nothing to draw.
class OverviewCharts {
    Q_DECLARE_TR_FUNCTIONS(OverviewCharts)
public:
    static QString title(OverviewChart chart);

    static BarChart times(const Outcome& outcome);
    static BarChart stock(const Outcome& outcome);
    static BarChart diameters(const Outcome& outcome);
    static BarChart requirements(const Outcome& outcome);
    /// Measured diameters stand beside the predicted ones.
    static BarChart boxes(const BatchOutcome& batch,
                          const std::vector<MeasuredStatistics>& measured = {});
    static BarChart parts(const BatchOutcome& batch);
    static BarChart runs(const std::vector<RunBars>& runs, int kept); ///< of so many kept ones

    /// What the bars of a chart stand for, category by category: a stage, from 0; a section, from
    /// 0; a requirement.
    static std::vector<std::size_t> stagesShown(const Outcome& outcome);
    static std::vector<int> sectionsOfDiameters(const Outcome& outcome);
    static std::vector<ConstraintResult> requirementsShown(const Outcome& outcome);

    static constexpr int mostRuns = 8;            ///< kept ones, the newest
    static constexpr std::size_t mostStages = 24; ///< those that take longest

private:
    static std::vector<BarSeries> stepSeries(const Outcome& outcome);
    static QString stagesRemark(const Outcome& outcome);
    static QString sectionsRemark(const Outcome& outcome);
    /// A zone by its name, a section by its number.
    static QString briefPlace(const Outcome& outcome, int section);
};

} // namespace sparkout
