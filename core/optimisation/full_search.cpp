// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/full_search.h"

#include "core/optimisation/judge.h"

#include <algorithm>
#include <mutex>
#include <thread>

namespace sparkout {

namespace {

/// Hands out the cycles of the grid in portions, and gathers what came of them.
class FullSearch {
public:
    FullSearch(const Project& project, const Grid& grid, const SearchOptions& options)
        : m_project(project), m_grid(grid), m_options(options), m_best(grid, options) {
        if (options.resume) {
            m_last = options.resume->last;
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
        summary.checkpoint = {m_last, summary.best, m_options.variant};
        if (!m_exhausted) {
            summary.status = SearchStatus::stopped;
        } else if (summary.best) {
            summary.status = SearchStatus::proved;
            summary.bound_s = summary.best->time_s;
        }
        return summary;
    }

private:
    static constexpr int portion = 64;

    void work() {
        CycleRunner runner(m_project, m_grid);
        Judge judge(m_grid, m_options);
        while (true) {
            const std::vector<GridCycle> cycles = take(judge);
            if (cycles.empty()) {
                return;
            }
            for (const GridCycle& cycle : cycles) {
                judge.decide(cycle, runner);
            }
        }
    }

    /// Gives back what came of the last portion and takes the next. What was taken is always
    /// finished, so a stopped search can go on behind the last one taken.
    std::vector<GridCycle> take(Judge& judge) {
        const std::scoped_lock lock(m_mutex);
        m_best.counts.add(judge.counts);
        judge.counts = {};
        if (judge.best()) {
            m_best.offer(*judge.best());
        }
        if (m_best.best()) {
            judge.offer(*m_best.best());
        }
        if (m_options.onProgress) {
            m_options.onProgress({m_best.best(), 0, m_best.counts.evaluations, 0});
        }
        std::vector<GridCycle> cycles;
        GridCycle next = m_last;
        while (!m_exhausted && cycles.size() < portion && !m_options.stop.stop_requested()) {
            if (!m_grid.next(next)) {
                m_exhausted = true;
                break;
            }
            m_last = next;
            cycles.push_back(next);
        }
        return cycles;
    }

    const Project& m_project;
    const Grid& m_grid;
    const SearchOptions& m_options;
    std::mutex m_mutex; ///< of what follows
    Judge m_best;
    GridCycle m_last; ///< handed out
    bool m_exhausted = false;
};

} // namespace

SearchSummary fullSearch(const Project& project, const Grid& grid, const SearchOptions& options) {
    return FullSearch(project, grid, options).run();
}

} // namespace sparkout
