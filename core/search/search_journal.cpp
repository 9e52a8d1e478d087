// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/search_journal.h"

#include "core/search/cycle_runner.h"
#include "core/search/judge.h"
#include "core/search/variants.h"

namespace sparkout {

namespace {

bool isCycleOf(const Variants& variants, std::size_t variant, const GridCycle& cycle) {
    return variant < variants.count() && variants.grid(variant).contains(cycle);
}

/// Whether a search of these variants may have been so far.
bool isOf(const Variants& variants, const SearchCheckpoint& at) {
    return at.variant < variants.count()
           && (at.last.empty() || isCycleOf(variants, at.variant, at.last))
           && (!at.best || isCycleOf(variants, at.best->variant, at.best->cycle));
}

enum class Trust { given, refused, stopped };

/// Whether the best cycle is feasible, with the same result as recorded.
Trust trustIn(const Variants& variants, const SearchCheckpoint& at, const SearchOptions& options) {
    if (!isOf(variants, at)) {
        return Trust::refused;
    }
    if (!at.best) {
        return Trust::given;
    }
    const FeasibleCycle& kept = *at.best;
    const Project& project = variants.project(kept.variant);
    const Grid& grid = variants.grid(kept.variant);
    SearchOptions alone = options;
    alone.incumbent.reset();
    alone.wholeMargin = nullptr; // it would count the cycles
    alone.variant = kept.variant;
    for (Project& scenario : alone.scenarios) {
        setMachine(scenario, machineSettings(project));
    }
    Judge judge(grid, alone);
    CycleRunner runner(project, grid, options.stop);
    judge.decide(kept.cycle, runner);
    if (options.stop.stop_requested()) {
        return Trust::stopped;
    }
    const std::optional<FeasibleCycle>& found = judge.best();
    const bool isSame =
        found && found->time_us == kept.time_us && found->time_s == kept.time_s
        && (options.wholeMargin ? kept.leastRelativeMargin <= found->leastRelativeMargin
                                : kept.leastRelativeMargin == found->leastRelativeMargin);
    return isSame ? Trust::given : Trust::refused;
}

SearchCheckpoint sumOf(SearchCheckpoint at, const SearchCheckpoint& before) {
    at.evaluations += before.evaluations;
    at.visits += before.visits;
    for (std::size_t kind = 0; kind < at.cuts.size(); ++kind) {
        at.cuts[kind] += before.cuts[kind];
    }
    return at;
}

/// The result of a finished search.
SearchSummary summaryOf(const Variants& variants, const SearchCheckpoint& found,
                        const SearchOptions& options) {
    SearchSummary summary;
    summary.best = found.best;
    summary.checkpoint = found;
    summary.evaluations = found.evaluations;
    summary.visits = found.visits;
    summary.cuts = found.cuts;
    summary.gridSize = variants.size();
    if (found.best) {
        summary.status = SearchStatus::proved;
        summary.bound_s = options.marginWithin_us ? 0 : found.best->time_s;
        summary.cycle = variants.grid(found.best->variant).cycle(found.best->cycle);
        summary.machine = machineSettings(variants.project(found.best->variant));
    }
    return summary;
}

} // namespace

SearchSummary SearchJournal::search(const Project& project, const SearchOptions& options) {
    const Variants variants(project, options.stop);
    const std::size_t number = m_asked++;
    const auto trust = [&](const SearchCheckpoint& at) {
        const Trust found = trustIn(variants, at, options);
        m_hasRefused = m_hasRefused || found == Trust::refused;
        return found;
    };
    SearchSummary stopped;
    stopped.status = SearchStatus::stopped;
    stopped.gridSize = variants.size();
    if (number < m_record.finished.size()) {
        switch (trust(m_record.finished[number])) {
        case Trust::given: return summaryOf(variants, m_record.finished[number], options);
        case Trust::stopped: return stopped; // the record stays
        case Trust::refused: break;
        }
        m_record.finished.resize(number);
        m_record.begun.reset();
    }
    if (m_record.begun) {
        switch (trust(*m_record.begun)) {
        case Trust::given: break;
        case Trust::stopped: return stopped;
        case Trust::refused: m_record.begun.reset();
        }
    }
    SearchOptions own = options;
    own.journal = nullptr;
    own.resume = m_record.begun;
    const SearchCheckpoint before = m_record.begun.value_or(SearchCheckpoint());
    own.onProgress = [&](SearchProgress progress) {
        progress.evaluations += before.evaluations;
        progress.share =
            static_cast<double>(progress.evaluations) / static_cast<double>(variants.size());
        if (progress.checkpoint) {
            m_record.begun = sumOf(*std::move(progress.checkpoint), before);
            progress.checkpoint = m_record.begun;
            if (onStep) {
                onStep(m_record);
            }
        }
        if (options.onProgress) {
            options.onProgress(progress);
        }
    };
    SearchSummary found = searchVariants(project, own);
    const SearchCheckpoint whole = sumOf(found.checkpoint, before);
    found.evaluations = whole.evaluations;
    found.visits = whole.visits;
    found.cuts = whole.cuts;
    if (found.status != SearchStatus::stopped) {
        m_record.finished.push_back(whole);
        m_record.begun.reset();
    } else if (found.checkpoint.evaluations > 0) { // otherwise it is still at its beginning
        m_record.begun = whole;
    }
    found.checkpoint = whole;
    if (onStep) {
        onStep(m_record);
    }
    return found;
}

} // namespace sparkout
