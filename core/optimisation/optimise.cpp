// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/optimise.h"

#include "core/optimisation/dynamic_programming.h"
#include "core/optimisation/full_search.h"
#include "core/optimisation/pruned_search.h"

namespace sparkout {

namespace {

SearchSummary search(const Project& project, const Grid& grid, const SearchOptions& options) {
    switch (options.method) {
    case SearchMethod::full: return fullSearch(project, grid, options);
    case SearchMethod::published: return publishedProgramming(project, grid, options);
    case SearchMethod::labels: return labelSetting(project, grid, options);
    case SearchMethod::pruned: break;
    }
    return prunedSearch(project, grid, options);
}

} // namespace

SearchSummary optimise(const Project& project, const SearchOptions& options) {
    const Grid grid(project);
    SearchSummary summary = search(project, grid, options);
    summary.gridSize = grid.size();
    if (summary.best) {
        summary.cycle = grid.cycle(summary.best->cycle);
    }
    return summary;
}

} // namespace sparkout
