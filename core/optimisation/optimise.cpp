// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/optimise.h"

#include "core/optimisation/full_search.h"
#include "core/optimisation/pruned_search.h"

namespace sparkout {

SearchSummary optimise(const Project& project, const SearchOptions& options) {
    const Grid grid(project);
    SearchSummary summary = options.method == SearchMethod::full
                                ? fullSearch(project, grid, options)
                                : prunedSearch(project, grid, options);
    summary.gridSize = grid.size();
    if (summary.best) {
        summary.cycle = grid.cycle(summary.best->cycle);
    }
    return summary;
}

} // namespace sparkout
