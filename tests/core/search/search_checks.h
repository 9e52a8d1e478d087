// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/optimise.h"
#include "tests/core/search/plain_grid.h"
#include "tests/core/search/search_cases.h"
#include "tests/core/support/project_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

/// What the tests of the searches share.
namespace sparkout::search_checks {

using plain_grid::PlainCycle;
using plain_grid::PlainGrid;
using plain_grid::sameCycle;
using search_cases::holds;
using search_cases::smallCase;

/// The best cycle of a grid by its definition: every cycle is simulated to its end.
struct PlainSearch {
    std::optional<PlainCycle> best;
    std::int64_t time_us = 0;
    double margin = 0;
    long long visits = 0;

    explicit PlainSearch(Project project) {
        const PlainGrid grid(project);
        for (const PlainCycle& each : grid.cycles) {
            *project.cycle = each.cycle;
            setMachine(project, each.machine);
            const SimulationResult result = simulateUnchecked(project);
            visits += result.visits;
            const auto taken_us = static_cast<std::int64_t>(std::llround(result.time_s * 1e6));
            double least = std::numeric_limits<double>::infinity();
            for (const ConstraintResult& constraint : evaluateConstraints(result)) {
                least = std::min(least, constraint.relativeMargin);
            }
            if (holds(result)
                && (!best || taken_us < time_us || (taken_us == time_us && least > margin))) {
                best = each;
                time_us = taken_us;
                margin = least;
            }
        }
    }
};

inline bool same(const SearchSummary& a, const PlainSearch& b) {
    return a.best.has_value() == b.best.has_value()
           && (!a.best
               || (sameCycle(a.cycle, b.best->cycle) && a.machine == b.best->machine
                   && a.best->time_us == b.time_us && a.best->leastRelativeMargin == b.margin));
}

inline bool same(const SearchSummary& a, const SearchSummary& b) {
    return a.best.has_value() == b.best.has_value()
           && (!a.best
               || (a.best->cycle == b.best->cycle && a.best->variant == b.best->variant
                   && a.best->time_us == b.best->time_us
                   && a.best->leastRelativeMargin == b.best->leastRelativeMargin));
}

/// Fewer under the sanitizers.
inline unsigned searches(int usual) {
    return static_cast<unsigned>(samples::sized(usual, usual * 2 / 5, usual * 2));
}

/// Of an option held against all cycles of its grids: 500 in --long.
inline unsigned plainGrids(int usual) {
    return static_cast<unsigned>(samples::sized(usual, usual * 2 / 5, std::max(usual, 500)));
}

inline SearchSummary search(const Project& project, SearchMethod method = SearchMethod::pruned,
                            unsigned threads = 1) {
    SearchOptions options;
    options.method = method;
    options.threads = threads;
    return optimise(project, options);
}

/// No worse: as quick or quicker, where the other found one.
inline bool noSlower(const SearchSummary& a, const SearchSummary& b) {
    return !b.best || (a.best && a.best->time_us <= b.best->time_us);
}

/// One stage whose drive allows the feed given, or a little more, out of 0.3, 0.6 and 1.2 mm/min.
inline Project driven(double feed_mm_min) {
    Project p = fixtures::plunge();
    p.material->burn_rise_k.reset();
    p.part->lower_deviation_um = -200;
    p.part->upper_deviation_um = 200;
    p.part->tolerance = {};
    p.machine->limits = {};
    p.optimisation = Optimisation{};
    p.optimisation->stages = {1};
    p.optimisation->radial_feed_mm_min = std::vector<double>{0.3, 0.6, 1.2};
    p.cycle->stages = {fixtures::plungeStage(feed_mm_min, p.part->stock_mm)};
    p.machine->wheel_drive_kw = simulateUnchecked(p).peakPower_w / 1000 * 1.001;
    return p;
}

} // namespace sparkout::search_checks
