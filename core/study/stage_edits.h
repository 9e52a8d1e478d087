// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <string_view>

/// Edits of the stages that leave the sum of their stocks as it is, and feeds in the forms that
/// tables of cutting data and drawings of a shop have.
namespace sparkout {

/// A feed per revolution of the work and, of one along it, as a share of the wheel's width.
struct FeedForms {
    double perRevolution_mm = 0;
    std::optional<double> ofWidth;
};

/// Of a feed in mm/min, a column of the stages; nothing of other columns, or while nothing turns.
[[nodiscard]] std::optional<FeedForms> feedForms(const Project& project, const Field& column,
                                                 double feed_mm_min);

/// A feed that is typed in one of these forms, "12 mm/rev" or, of one along the work, "0.3B", in
/// mm/min, to a step of the machine where it has one. Nothing when it is no such text.
[[nodiscard]] std::optional<double> feedFromForm(const Project& project, const Field& column,
                                                 std::string_view text);

/// A stock without last bits such as 0.30000000000000004 [mm].
[[nodiscard]] double tidyStock(double stock_mm);

/// The project with a stage more behind one that feeds: with the feeds of that one and half of its
/// stock, in whole micrometres where that leaves any.
[[nodiscard]] Project withStageAfter(Project project, std::size_t stage);

/// The project with another stock of a stage; another stage has the difference.
[[nodiscard]] Project withStock(Project project, std::size_t stage, double stock_mm,
                                std::size_t other);

/// Of the spark-out that is offered: 2 double strokes, or the whole revolutions in 3 s, 3 at least:
/// an estimate, the low end of the 3 to 8 s that are usual.
[[nodiscard]] int usualSparkOut(const Project& project);

/// The project with a spark-out of so many double strokes or revolutions as its last stage. The
/// table travels as in the stage before.
[[nodiscard]] Project withSparkOutAfter(Project project, int steps);

/// The project with a continuous infeed stated in every stage that feeds, 0 where there was none;
/// or with none at all.
[[nodiscard]] Project withContinuousInfeed(Project project, bool stated);
/// Whether a stage states one, be it 0.
[[nodiscard]] bool statesContinuousInfeed(const Project& project);

} // namespace sparkout
