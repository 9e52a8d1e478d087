// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/search_journal.h"

#include "core/optimisation/variants.h"

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

SearchCheckpoint sumOf(SearchCheckpoint at, const SearchCheckpoint& before) {
    at.evaluations += before.evaluations;
    at.visits += before.visits;
    for (std::size_t kind = 0; kind < at.cuts.size(); ++kind) {
        at.cuts[kind] += before.cuts[kind];
    }
    return at;
}

/// What a finished search gave.
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
    if (number < m_record.finished.size()) {
        if (isOf(variants, m_record.finished[number])) {
            return summaryOf(variants, m_record.finished[number], options);
        }
        m_record.finished.resize(number);
        m_record.begun.reset();
    }
    if (m_record.begun && !isOf(variants, *m_record.begun)) {
        m_record.begun.reset();
    }
    SearchOptions own = options;
    own.journal = nullptr;
    own.resume = m_record.begun;
    const SearchCheckpoint before = m_record.begun.value_or(SearchCheckpoint());
    own.onProgress = [&](SearchProgress progress) {
        progress.evaluations += before.evaluations;
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
    SearchSummary found = optimise(project, own);
    const SearchCheckpoint whole = sumOf(found.checkpoint, before);
    found.evaluations = whole.evaluations;
    found.visits = whole.visits;
    found.cuts = whole.cuts;
    if (found.status != SearchStatus::stopped) {
        m_record.finished.push_back(whole);
        m_record.begun.reset();
    } else if (found.checkpoint.evaluations > 0) { // else it is where it began
        m_record.begun = whole;
    }
    found.checkpoint = whole;
    if (onStep) {
        onStep(m_record);
    }
    return found;
}

} // namespace sparkout
