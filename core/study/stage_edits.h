// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <string_view>

/// Edits of the stages that keep the sum of their stocks, and feeds in the units of cutting data
/// tables and shop drawings.
namespace sparkout {

/// A feed per revolution of the work and, for an axial one, as a share of the wheel's width.
struct FeedForms {
    double perRevolution_mm = 0;
    std::optional<double> ofWidth;
};

/// Returns the forms of a feed in mm/min from a column of the stages; empty for other columns, or
/// if the work does not turn.
[[nodiscard]] std::optional<FeedForms> feedForms(const Project& project, const Field& column,
                                                 double feed_mm_min);

/// Returns a feed typed as "12 mm/rev" or, for an axial feed, "0.3B", in mm/min, rounded to a step
/// of the machine where it has one; empty if the text is not of this form.
[[nodiscard]] std::optional<double> feedFromForm(const Project& project, const Field& column,
                                                 std::string_view text);

/// Returns a stock without rounding errors such as 0.30000000000000004 [mm].
[[nodiscard]] double tidyStock(double stock_mm);

/// Returns the project with an additional stage after one that feeds: with the feeds of that one
/// and half of its stock, in whole micrometres where that leaves any.
[[nodiscard]] Project withStageAfter(Project project, std::size_t stage);

/// Returns the project with another stock of a stage; `other` takes the difference.
[[nodiscard]] Project withStock(Project project, std::size_t stage, double stock_mm,
                                std::size_t other);

/// Returns the number of steps of the offered spark-out: 2 double strokes, or the whole revolutions
/// in 3 s, at least 3; this is an estimate at the low end of the usual 3 to 8 s.
[[nodiscard]] int usualSparkOut(const Project& project);

/// Returns the project with a spark-out of this number of double strokes or revolutions as its last
/// stage. The axial feed is that of the stage before.
[[nodiscard]] Project withSparkOutAfter(Project project, int steps);

/// Returns the project with a continuous infeed stated in every stage that feeds, 0 where there was
/// none, or with none at all.
[[nodiscard]] Project withContinuousInfeed(Project project, bool stated);
/// Returns whether a stage states a continuous infeed, even 0.
[[nodiscard]] bool statesContinuousInfeed(const Project& project);

// Edits of a project's stock.

/// Returns whether the stocks of the stages add up to the part's, as validate() requires.
[[nodiscard]] bool stocksAddUp(const Project& project);

/// Returns the project with stocks of the stages that add up to the part's. The first stage takes
/// the stock that the later ones leave, as it does in the cycle anyway [MODEL-7], so that nothing
/// else changes; where they leave none, all stages keep their share of the sum.
[[nodiscard]] Project withFittedStocks(Project project);

} // namespace sparkout
