// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/search_journal.h"
#include "core/study/search.h"
#include "core/study/whole_batch.h"
#include "core/sweep/sweep_run.h"
#include "ui/session/job.h"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace sparkout {

using SweepResultPtr = std::shared_ptr<const SweepResult>;
using SobolIndicesPtr = std::shared_ptr<const SobolIndices>;

[[nodiscard]] inline const Project& studied(const BatchOutcome& outcome) {
    return outcome.result.project;
}
[[nodiscard]] inline const Project& studied(const SweepResult& outcome) {
    return outcome.project;
}
[[nodiscard]] inline const Project& studied(const SearchOutcome& outcome) {
    return outcome.project;
}

/// A result that is computed on demand from the inputs of the document: what stands, whether it is
/// of the present inputs, what is being computed, and what could not be.
template <class Outcome>
class StudyOf {
public:
    using Ptr = std::shared_ptr<const Outcome>;
    /// Whether two projects have the same answer.
    using Same = bool (*)(const Project&, const Project&);

    explicit StudyOf(Same same) : m_same(same) {}

    [[nodiscard]] Job& job() { return m_job; } ///< progress, stop, and when it has answered
    [[nodiscard]] const Ptr& result() const { return m_result; } ///< the last one that was computed
    [[nodiscard]] const Ptr& refusal() const { return m_refusal; } ///< of the present inputs
    [[nodiscard]] bool stale() const { return m_stale; } ///< there is no result of these inputs
    [[nodiscard]] bool running() const { return m_job.running(); }
    [[nodiscard]] bool isOf(const Project& project) const { ///< there is a result of it
        return m_result && m_same(studied(*m_result), project);
    }

    /// The present inputs, null: there are none. What runs of others is dropped.
    void follow(const Project* present) {
        m_present = present ? std::optional(*present) : std::nullopt;
        const bool runsOthers = m_running && present && !m_same(*m_running, *present);
        noteStale();
        if (!m_stale || runsOthers) {
            m_refusal.reset();
        }
        if (running() && runsOthers) {
            m_job.drop();
        }
    }
    void forget() { ///< another document comes, or the project has nothing to compute
        m_job.drop();
        m_result.reset();
        m_refusal.reset();
        noteStale();
    }
    /// Computes the result of a project; what `work(means)` gives is taken as take() does.
    template <class Work>
    void start(const Project& project, std::int64_t parts, Work work) {
        m_running = project;
        m_refusal.reset();
        m_job.start(parts, std::move(work), [this](const Ptr& outcome) { take(outcome); });
    }
    /// A result, or a refusal; null: it was stopped before there was anything to show.
    void take(const Ptr& outcome) {
        if (outcome && !outcome->ran()) {
            m_refusal = outcome;
        } else if (outcome) {
            m_result = outcome;
        }
        noteStale();
    }

private:
    void noteStale() { m_stale = !m_present || !isOf(*m_present); }

    Same m_same;
    std::optional<Project> m_present, m_running;
    Ptr m_result, m_refusal;
    bool m_stale = true;
    Job m_job; ///< last: ended before what it gives its result to is gone
};

/// The search, whose answer stands before it ends, and of which one knows how far it is. One that
/// was stopped is continued, where that can be.
class SearchStudy : public StudyOf<SearchOutcome> {
public:
    SearchStudy();

    void start(const Project& project, const SearchWish& wish);
    void forget(); ///< another document comes
    /// The last search was this one, and was stopped: started again it is continued, and its answer
    /// is the same as without the stop.
    [[nodiscard]] bool isContinued(const Project& project, const SearchWish& wish) const;
    [[nodiscard]] SearchState state() const; ///< of the one that is running
    /// The answer of what is running stands; its front is still looked for.
    [[nodiscard]] bool isAnswered() const { return result() && result()->isFrontComing; }
    void follow(const Project* present);

private:
    void endAnswer(); ///< its search has been dropped: no margins by time will come

    struct Shared {
        std::mutex mutex;
        SearchState state;
        std::optional<Project> project; ///< that is searched; none: nothing was
        SearchWish wish;
        SearchRecord record; ///< how to continue it; empty: not at all
    };
    std::shared_ptr<Shared> m_shared = std::make_shared<Shared>();
};

/// The batch of a project; null: it was stopped before its first part.
[[nodiscard]] BatchOutcomePtr batchOf(const Project& project, const Job::Means& means);

/// All that the window computes on demand, for its views, reports and exports.
struct Studies {
    Studies();

    StudyOf<BatchOutcome> batch;
    StudyOf<BatchOutcome> judged;     ///< of the verdict, where that of the view is of other inputs
    StudyOf<BatchOutcome> prediction; ///< of what was measured
    StudyOf<SweepResult> sweep;
    SearchStudy search;

    /// Of the present inputs, run whole; null: none.
    [[nodiscard]] BatchOutcomePtr currentPrediction() const;
    /// Of the batch that is shown; null: none were asked for, or there are none.
    [[nodiscard]] const SobolIndicesPtr& indices() const { return m_indices; }
    [[nodiscard]] Job& indexJob() { return m_indexJob; }
    /// Whether they were asked for of the batch that is shown, whatever came of it.
    [[nodiscard]] bool haveIndicesBeenTried() const { return m_indicesOf == batch.result(); }

    void runBatch(const Project& project);
    void runJudged(const Project& project);
    void runPrediction(const Project& project);
    void runIndices(int points); ///< of the batch that is shown
    void runSweep(const Project& project);
    void dropIndices();

private:
    SobolIndicesPtr m_indices;
    BatchOutcomePtr m_indicesOf;
    Job m_indexJob; ///< last
};

} // namespace sparkout
