// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/studies.h"

#include "core/file/project_file.h"
#include "core/study/batch_edits.h"
#include "core/study/search_edits.h"
#include "core/study/sweep_edits.h"

#include <algorithm>

namespace sparkout {

SearchStudy::SearchStudy() : StudyOf(sameSearch) {}

void SearchStudy::start(const Project& project, const SearchWish& wish) {
    endAnswer();
    auto shared = std::make_shared<Shared>();
    SearchOutcomePtr before;
    if (isContinued(project, wish)) {
        shared->record = m_shared->record; // kept even if the search is dropped at once
        before = stale() ? nullptr : result();
    }
    shared->project = project;
    shared->wish = wish;
    m_shared = shared;
    StudyOf::start(project, 0, [this, project, shared, wish, before](const Job::Means& means) {
        const auto note = [&shared](const SearchState& state) {
            const std::lock_guard lock(shared->mutex);
            shared->state = state;
        };
        const auto answer = [this, &means](const SearchOutcomePtr& outcome) {
            means.post([this, outcome] { take(outcome); });
        };
        SearchJournal journal(shared->record);
        SearchWish own = wish;
        own.threads = static_cast<unsigned>(means.threads);
        own.journal = isResumable(project, wish.method) ? &journal : nullptr;
        SearchOutcomePtr outcome =
            search(project, own, means.stop, {.note = note, .answer = answer});
        const bool isStopped = means.stop.stop_requested();
        const std::lock_guard lock(shared->mutex);
        shared->record = isStopped ? journal.record() : SearchRecord();
        // If stopped before the kept best was confirmed, that remains the best so far.
        return isStopped && before && before->best() && !outcome->best() ? before : outcome;
    });
}

/// A refinement and margins by time follow the recorded search.
bool SearchStudy::isContinued(const Project& project, const SearchWish& wish) const {
    const std::lock_guard lock(m_shared->mutex);
    return !running() && (m_shared->record.begun || !m_shared->record.finished.empty())
           && wish.method == m_shared->wish.method && wish.phases == m_shared->wish.phases
           && m_shared->project && sameSearch(*m_shared->project, project);
}

void SearchStudy::forget() {
    StudyOf::forget();
    m_shared = std::make_shared<Shared>();
}

void SearchStudy::follow(const Project* present) {
    StudyOf::follow(present);
    if (!running()) {
        endAnswer();
    }
}

SearchState SearchStudy::state() const {
    const std::lock_guard lock(m_shared->mutex);
    return m_shared->state;
}

void SearchStudy::endAnswer() {
    if (isAnswered()) {
        auto ended = std::make_shared<SearchOutcome>(*result());
        ended->isFrontComing = false;
        take(ended);
    }
}

namespace {

BatchOptions batchOptions(const Job::Means& means) {
    BatchOptions options;
    options.threads = means.threads;
    options.stop = means.stop;
    options.done = means.done;
    return options;
}

} // namespace

BatchOutcomePtr batchOf(const Project& project, const Job::Means& means) {
    BatchOutcomePtr outcome = runWholeBatch(project, batchOptions(means));
    return outcome->ran() && outcome->summary.parts == 0 ? nullptr : outcome;
}

Studies::Studies()
    : batch(sameBatch)
    , judged(sameBatch)
    , prediction(sameBatch)
    , heldOut(sameProject)
    , sweep(sameSweep) {}

void Studies::runBatch(const Project& project) {
    batch.start(project, partsOf(project),
                [project](const Job::Means& means) { return batchOf(project, means); });
}

void Studies::runJudged(const Project& project) {
    judged.start(project, partsOf(project),
                 [project](const Job::Means& means) { return batchOf(project, means); });
}

void Studies::runPrediction(const Project& project) {
    prediction.start(project, partsOf(project),
                     [project](const Job::Means& means) { return batchOf(project, means); });
}

BatchOutcomePtr Studies::currentPrediction() const {
    const BatchOutcomePtr& of = prediction.result();
    return prediction.stale() || of->result.status != BatchStatus::completed ? nullptr : of;
}

void Studies::runHoldOut(const Project& project) {
    heldOut.start(project, 0, [project](const Job::Means& means) {
        return std::make_shared<const HeldOut>(HeldOut{project, holdOut(project, means.stop)});
    });
}

std::vector<HoldOutRow> Studies::currentHeldOut() const {
    return heldOut.stale() ? std::vector<HoldOutRow>() : heldOut.result()->rows;
}

void Studies::runIndices(int points) {
    const BatchOutcomePtr of = m_indicesOf = batch.result();
    m_indexJob.start(
        partsOfIndices(of->result.project, points),
        [of, points](const Job::Means& means) {
            const auto found = sobolIndices(of->result.project, points, batchOptions(means));
            return found ? std::make_shared<const SobolIndices>(*found) : SobolIndicesPtr();
        },
        [this](const SobolIndicesPtr& indices) { m_indices = indices; });
}

void Studies::dropIndices() {
    m_indexJob.drop();
    m_indices.reset();
}

void Studies::runSweep(const Project& project) {
    sweep.start(project, pointsOf(project), [project](const Job::Means& means) -> SweepResultPtr {
        auto result = std::make_shared<SweepResult>(
            sparkout::runSweep(project, {means.threads, means.stop, means.done}));
        const bool isDone =
            !result->ran() || std::ranges::any_of(result->points, [](const auto& p) {
                return p.status != SweepStatus::pending;
            });
        return isDone ? result : nullptr;
    });
}

} // namespace sparkout
