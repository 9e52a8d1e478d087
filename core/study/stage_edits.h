// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>

/// Edits of the stages that leave the sum of their stocks as it is.
namespace sparkout {

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
