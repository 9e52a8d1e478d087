// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/full_search.h"

#include "core/optimisation/judge.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Hands out the cycles of the grid in portions, and collects their results.
class FullSearch {
public:
    FullSearch(const Project& project, const Grid& grid, const SearchOptions& options)
        : m_project(project), m_grid(grid), m_options(options), m_best(grid, options) {
        if (options.resume) {
            m_handed = m_last = options.resume->last;
        }
    }

    SearchSummary run() {
        const unsigned threads = m_options.threads > 0
                                     ? m_options.threads
                                     : std::max(1U, std::thread::hardware_concurrency());
        {
            std::vector<std::jthread> others;
            for (unsigned i = 1; i < threads; ++i) {
                others.emplace_back([this] { work(); });
            }
            work();
        } // waits for the others
        SearchSummary summary;
        summary.best = m_best.best();
        summary.evaluations = m_best.counts.evaluations;
        summary.visits = m_best.counts.visits;
        summary.cuts = m_best.counts.cuts;
        summary.checkpoint = checkpoint();
        if (!m_exhausted || m_cutShort) {
            summary.status = SearchStatus::stopped;
        } else if (summary.best) {
            summary.status = SearchStatus::proved;
            summary.bound_s = summary.best->time_s;
        }
        return summary;
    }

private:
    static constexpr int portionSize = 64;

    /// Cycles that follow each other in the grid.
    struct Portion {
        long long number = 0; ///< in the order of the portions
        std::vector<GridCycle> cycles;
        std::size_t done = 0; ///< number of decided cycles: fewer after a stop
        SearchCounts counts;  ///< counts of these cycles
        [[nodiscard]] bool isDone() const { return done == cycles.size(); }
    };

    [[nodiscard]] SearchCheckpoint checkpoint() const {
        const SearchCounts& counts = m_best.counts;
        return {m_last,        m_best.best(), m_options.variant, counts.evaluations,
                counts.visits, counts.cuts};
    }

    void work() {
        CycleRunner runner(m_project, m_grid, m_options.stop);
        Judge judge(m_grid, m_options);
        for (Portion portion = take(judge); !portion.cycles.empty(); portion = take(judge)) {
            for (const GridCycle& cycle : portion.cycles) {
                const long long before = judge.counts.evaluations;
                judge.decide(cycle, runner);
                if (judge.counts.evaluations == before) {
                    break; // stopped within it
                }
                ++portion.done;
            }
            portion.counts = std::exchange(judge.counts, {});
            giveBack(std::move(portion), judge);
        }
    }

    /// Decided cycles are counted in grid order up to the first undecided one: a resumed search
    /// begins after the last counted cycle, and repeats those that other threads decided beyond it.
    void giveBack(Portion portion, const Judge& judge) {
        const std::scoped_lock lock(m_mutex);
        if (judge.best()) {
            m_best.offer(*judge.best());
        }
        m_done.emplace(portion.number, std::move(portion));
        for (auto first = m_done.find(m_counted); !m_cutShort && first != m_done.end();
             first = m_done.find(m_counted)) {
            const Portion& next = first->second;
            m_best.counts.add(next.counts);
            m_last = next.done > 0 ? next.cycles[next.done - 1] : m_last;
            m_cutShort = !next.isDone();
            m_done.erase(first);
            ++m_counted;
        }
        if (m_options.onProgress) {
            m_options.onProgress({m_best.best(), 0, m_best.counts.evaluations, 0, checkpoint()});
        }
    }

    /// Returns the next cycles; empty at the end or after a stop.
    Portion take(Judge& judge) {
        const std::scoped_lock lock(m_mutex);
        if (m_best.best()) {
            judge.offer(*m_best.best());
        }
        Portion portion;
        portion.number = m_portions;
        GridCycle next = m_handed;
        while (!m_exhausted && portion.cycles.size() < portionSize
               && !m_options.stop.stop_requested()) {
            if (!m_grid.next(next)) {
                m_exhausted = true;
                break;
            }
            m_handed = next;
            portion.cycles.push_back(next);
        }
        m_portions += portion.cycles.empty() ? 0 : 1;
        return portion;
    }

    const Project& m_project;
    const Grid& m_grid;
    const SearchOptions& m_options;
    std::mutex m_mutex; ///< guards the following members
    Judge m_best;
    GridCycle m_handed;                  ///< the last handed out
    GridCycle m_last;                    ///< the last counted
    std::map<long long, Portion> m_done; ///< returned, but not counted yet
    long long m_portions = 0, m_counted = 0;
    bool m_exhausted = false, m_cutShort = false;
};

} // namespace

SearchSummary fullSearch(const Project& project, const Grid& grid, const SearchOptions& options) {
    return FullSearch(project, grid, options).run();
}

} // namespace sparkout
