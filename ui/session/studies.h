// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/sweep_run.h"
#include "core/measured/hold_out.h"
#include "core/search/search_journal.h"
#include "core/study/outcome.h"
#include "core/study/search.h"
#include "core/study/whole_batch.h"
#include "ui/session/job.h"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// The traces of a project that no calibration has used, compared with their prediction.
struct HeldOut {
    Project project;
    std::vector<HoldOutRow> rows;

    [[nodiscard]] static bool ran() { return true; } ///< a project of a run is never refused
};

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
[[nodiscard]] inline const Project& studied(const HeldOut& outcome) {
    return outcome.project;
}

/// A result computed on demand from the inputs of the document: the last result, whether it belongs
/// to the current inputs, the running computation and a refusal.
template <class Outcome>
class StudyOf {
public:
    using Ptr = std::shared_ptr<const Outcome>;
    /// Returns whether two projects have the same answer.
    using Same = bool (*)(const Project&, const Project&);

    explicit StudyOf(Same same) : m_same(same) {}

    [[nodiscard]] Job& job() { return m_job; } ///< progress, stop and end of the computation
    [[nodiscard]] const Ptr& result() const { return m_result; } ///< last computed result
    [[nodiscard]] const Ptr& refusal() const {
        return m_refusal;
    } ///< refusal of the current inputs
    [[nodiscard]] bool stale() const {
        return m_stale;
    } ///< there is no result for the current inputs
    [[nodiscard]] bool running() const { return m_job.running(); }
    [[nodiscard]] bool isOf(const Project& project) const { ///< there is a result for this project
        return m_result && m_same(studied(*m_result), project);
    }

    /// Sets the current inputs, or null without any. A running computation for other inputs is
    /// discarded.
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
    void forget() { ///< clears the study for another document or a project without it
        m_job.drop();
        m_result.reset();
        m_refusal.reset();
        noteStale();
    }
    /// Computes the result of a project; the result of `work(means)` is passed to take().
    template <class Work>
    void start(const Project& project, std::int64_t parts, Work work) {
        m_running = project;
        m_refusal.reset();
        m_job.start(parts, std::move(work), [this](const Ptr& outcome) { take(outcome); });
    }
    /// Takes a result or a refusal; null if it was stopped before there was a result.
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
    Job m_job; ///< last: ended before the members that receive its result are destroyed
};

/// The search, which gives its answer before it ends and reports its progress. A stopped search is
/// continued where that is possible.
class SearchStudy : public StudyOf<SearchOutcome> {
public:
    SearchStudy();

    void start(const Project& project, const SearchWish& wish);
    void forget(); ///< before another document
    /// Returns whether the last search was this one and was stopped: started again it is continued,
    /// and its answer is the same as without the stop.
    [[nodiscard]] bool isContinued(const Project& project, const SearchWish& wish) const;
    [[nodiscard]] SearchState state() const; ///< progress of the running search
    /// Returns whether the running search has given its answer and still searches for the front.
    [[nodiscard]] bool isAnswered() const { return result() && result()->isFrontComing; }
    void follow(const Project* present);

private:
    void endAnswer(); ///< after its search was discarded: there will be no front

    struct Shared {
        std::mutex mutex;
        SearchState state;
        std::optional<Project> project; ///< project of the search; empty: no search was made
        SearchWish wish;
        SearchRecord record; ///< record to continue it; empty: it cannot be continued
    };
    std::shared_ptr<Shared> m_shared = std::make_shared<Shared>();
};

/// Runs the batch of a project; null if it was stopped before its first part.
[[nodiscard]] BatchOutcomePtr batchOf(const Project& project, const Job::Means& means);

/// The result of the last run and all that the window computes on demand, for its views, reports
/// and exports.
struct Studies {
    Studies();

    OutcomePtr outcome; ///< of the last run, or the refusal of its inputs; null before the first
    StudyOf<BatchOutcome> batch;
    StudyOf<BatchOutcome> judged;     ///< batch for the verdict, if the view's has other inputs
    StudyOf<BatchOutcome> prediction; ///< batch for the comparison with measurements
    StudyOf<HeldOut> heldOut;
    StudyOf<SweepResult> sweep;
    SearchStudy search;

    /// Returns the complete prediction for the current inputs; null if there is none.
    [[nodiscard]] BatchOutcomePtr currentPrediction() const;
    /// Returns the rows of the unused traces for the current inputs; empty until they are known.
    [[nodiscard]] std::vector<HoldOutRow> currentHeldOut() const;
    /// Returns the indices of the displayed batch; null if none were requested, or if there are
    /// none.
    [[nodiscard]] const SobolIndicesPtr& indices() const { return m_indices; }
    [[nodiscard]] Job& indexJob() { return m_indexJob; }
    /// Returns whether the indices of the batch that is shown were requested, whatever the result.
    [[nodiscard]] bool haveIndicesBeenTried() const { return m_indicesOf == batch.result(); }

    void runBatch(const Project& project);
    void runJudged(const Project& project);
    void runPrediction(const Project& project);
    void runHoldOut(const Project& project); ///< one or two cycles for each calibrated input
    void runIndices(int points);             ///< for the batch that is shown
    void runSweep(const Project& project);
    void dropIndices();

private:
    SobolIndicesPtr m_indices;
    BatchOutcomePtr m_indicesOf;
    Job m_indexJob; ///< last
};

} // namespace sparkout
