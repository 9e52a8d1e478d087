// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/part_runs.h"
#include "ui/session/part_study.h"
#include "ui/session/setup_state.h"
#include "ui/tables/value_table.h"

#include <map>
#include <vector>

namespace sparkout {

/// The results of the searches and batches of the surfaces, by the ids of the surfaces.
struct PartStudies {
    std::map<int, SurfaceStudyPtr> searches, batches;

    [[nodiscard]] bool empty() const { return searches.empty() && batches.empty(); }
    void add(int id, const SurfaceStudyPtr& study);
};

enum class PartColumn { surface, diameter, time, verdict, margin, search, batch };

/// A row for each surface: diameter, cycle time, verdict and least margin, followed by the results
/// of its search and batch, if they were run; the batch is otherwise that of the verdict.
[[nodiscard]] ValueTable partTable(const SetupState& state,
                                   const std::vector<SurfaceStatus>& statuses,
                                   const PartStudies& studies);

/// The surfaces side by side: a column for each, a row for the cycle time and for every requirement
/// of any surface, with value and limit at its worst place.
[[nodiscard]] ValueTable surfaceComparison(const SetupState& state,
                                           const std::vector<SurfaceStatus>& statuses);

} // namespace sparkout
