// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/optimise.h"

#include "core/grace_stop.h"
#include "core/optimisation/cycle_runner.h"
#include "core/optimisation/dynamic_programming.h"
#include "core/optimisation/full_search.h"
#include "core/optimisation/pruned_search.h"
#include "core/optimisation/search_journal.h"
#include "core/optimisation/time_bound.h"
#include "core/process/profile.h"
#include "core/project/optimisation.h"
#include "core/units.h"

#include <algorithm>
#include <limits>
#include <utility>

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

/// Searches variant by variant and combines the results.
class VariantSearch {
public:
    VariantSearch(const Project& project, const SearchOptions& options)
        : m_project(project)
        , m_variants(project, options.stop)
        , m_options(options)
        , m_own(options) {
        const Grace grace(options.stop);
        m_unprepared = m_variants.isCutShort();
        for (std::size_t v = 0; v < m_variants.count() && !m_unprepared; ++v) {
            m_unprepared = grace.isOver();
            if (m_variants.grid(v).fault() == GridFault::none) {
                m_order.emplace_back(leastTime_s(m_variants.project(v), m_variants.grid(v)), v);
            }
        }
        if (options.method != SearchMethod::full) { // a resumed search continues there
            std::sort(m_order.begin(), m_order.end());
        }
        if (options.resume) {
            std::erase_if(m_order,
                          [&](const auto& each) { return each.second < options.resume->variant; });
            m_own.incumbent = options.resume->best;
        }
        if (options.onProgress) {
            m_own.onProgress = [this](const SearchProgress& progress) { note(progress); };
        }
    }

    SearchSummary run() {
        if (m_unprepared) {
            SearchSummary none;
            none.status = SearchStatus::stopped;
            none.gridSize = gridSize(m_project);
            return none;
        }
        m_sum.bound_s = std::numeric_limits<double>::infinity();
        m_size = static_cast<double>(m_variants.size());
        for (m_at = 0; m_at < m_order.size(); ++m_at) {
            searchVariant(m_order[m_at].second);
            if (m_sum.status == SearchStatus::stopped) {
                break;
            }
        }
        finish();
        return m_sum;
    }

private:
    /// Least time of a cycle of the variants after the current one.
    [[nodiscard]] double restBound_s() const {
        double least_s = std::numeric_limits<double>::infinity();
        for (std::size_t i = m_at + 1; i < m_order.size(); ++i) {
            least_s = std::min(least_s, m_order[i].first);
        }
        return least_s;
    }

    void note(const SearchProgress& progress) const {
        SearchProgress all = progress;
        all.bound_s = std::min({progress.bound_s, m_sum.bound_s, restBound_s()});
        all.evaluations += m_sum.evaluations;
        if (m_options.method == SearchMethod::full) {
            all.share = static_cast<double>(all.evaluations) / m_size;
        }
        if (all.checkpoint) {
            addBefore(*all.checkpoint);
        }
        m_options.onProgress(all);
    }

    /// Adds the counts of the earlier variants.
    void addBefore(SearchCheckpoint& checkpoint) const {
        checkpoint.evaluations += m_sum.evaluations;
        checkpoint.visits += m_sum.visits;
        for (std::size_t kind = 0; kind < checkpoint.cuts.size(); ++kind) {
            checkpoint.cuts[kind] += m_sum.cuts[kind];
        }
    }

    void searchVariant(std::size_t variant) {
        m_own.variant = variant;
        const bool resumed = m_options.resume && m_options.resume->variant == variant;
        m_own.resume = resumed ? m_options.resume : std::nullopt;
        const MachineSettings machine = machineSettings(m_variants.project(variant));
        for (Project& scenario : m_own.scenarios) {
            setMachine(scenario, machine);
        }
        for (PhaseCase& each : m_own.cases) {
            setMachine(each.part, machine);
        }
        const SearchSummary found =
            search(m_variants.project(variant), m_variants.grid(variant), m_own);
        m_own.incumbent = found.best;
        m_sum.best = found.best;
        m_sum.checkpoint = found.checkpoint;
        addBefore(m_sum.checkpoint);
        m_sum.evaluations += found.evaluations;
        m_sum.visits += found.visits;
        for (std::size_t kind = 0; kind < found.cuts.size(); ++kind) {
            m_sum.cuts[kind] += found.cuts[kind];
        }
        for (const Project& scenario : found.added) {
            m_own.scenarios.push_back(scenario);
            m_sum.added.push_back(scenario);
        }
        for (const PhaseCase& each : found.addedCases) {
            m_own.cases.push_back(each);
            m_sum.addedCases.push_back(each);
        }
        m_sum.isStale = found.isStale;
        m_sum.status = found.status;
        const bool none = found.status == SearchStatus::infeasible && !found.best;
        m_sum.bound_s = none ? m_sum.bound_s : std::min(m_sum.bound_s, found.bound_s);
    }

    void finish() {
        if (m_options.marginWithin_us) {
            m_sum.bound_s = 0;
        } else if (m_sum.status == SearchStatus::stopped) {
            m_sum.bound_s = std::min(m_sum.bound_s, restBound_s());
        } else if (m_sum.best && !isHeuristic(m_options.method)) {
            m_sum.bound_s = m_sum.best->time_s;
        }
        m_sum.bound_s = m_sum.bound_s < 1e300 ? m_sum.bound_s : 0;
        if (m_sum.best) {
            m_sum.cycle = m_variants.grid(m_sum.best->variant).cycle(m_sum.best->cycle);
            m_sum.machine = machineSettings(m_variants.project(m_sum.best->variant));
        }
        m_sum.gridSize = m_variants.size();
    }

    const Project& m_project;
    Variants m_variants;
    const SearchOptions& m_options;
    SearchOptions m_own;                                 ///< options for the variants
    std::vector<std::pair<double, std::size_t>> m_order; ///< least time [s] and variant
    bool m_unprepared = false;                           ///< stopped before the search
    std::size_t m_at = 0;
    double m_size = 0;
    SearchSummary m_sum;
};

SearchSummary searchOnce(const Project& project, const SearchOptions& options) {
    return options.journal ? options.journal->search(project, options)
                           : searchVariants(project, options);
}

/// The quickest cycle whose margin equals the greatest one, which was found.
SearchSummary quickestOfMargin(const Project& project, const SearchOptions& options,
                               const SearchSummary& widest) {
    SearchOptions search = options;
    search.marginWithin_us.reset();
    search.resume.reset();
    search.incumbent = widest.best;
    search.beyondMargin = widest.best->leastRelativeMargin - equalMargins;
    if (options.onProgress) {
        search.onProgress = [&](SearchProgress progress) {
            progress.bound_s = 0;
            progress.evaluations += widest.evaluations;
            progress.share = 1;
            progress.checkpoint.reset(); // only the first search can be resumed
            options.onProgress(progress);
        };
    }
    SearchSummary found = searchOnce(project, search);
    found.bound_s = 0;
    found.evaluations += widest.evaluations;
    found.visits += widest.visits;
    for (std::size_t kind = 0; kind < found.cuts.size(); ++kind) {
        found.cuts[kind] += widest.cuts[kind];
    }
    found.checkpoint = widest.checkpoint;
    return found;
}

} // namespace

std::optional<std::int64_t> marginWithinOf(const Project& project) {
    const auto within_min =
        project.optimisation ? project.optimisation->margin_within_min : std::nullopt;
    return within_min ? std::optional(comparedTime_us(*within_min * units::secondsPerMinute))
                      : std::nullopt;
}

SearchSummary searchVariants(const Project& project, const SearchOptions& options) {
    return VariantSearch(project, options).run();
}

SearchSummary optimise(const Project& project, const SearchOptions& options) {
    const SearchSummary found = searchOnce(project, options);
    return options.marginWithin_us && found.best && found.status == SearchStatus::proved
               ? quickestOfMargin(project, options, found)
               : found;
}

Project withBest(Project project, const SearchSummary& summary) {
    setMachine(project, summary.machine);
    *project.cycle = summary.cycle;
    return project;
}

} // namespace sparkout
