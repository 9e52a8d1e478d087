// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_runs.h"

#include "core/project/batch.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/quality/roughness.h"
#include "core/setup/worn_project.h"
#include "core/study/batch_edits.h"
#include "core/study/search_edits.h"
#include "core/units.h"
#include "ui/session/studies.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace sparkout {

namespace {

constexpr std::int64_t steps = 1000; ///< resolution of a search's progress

/// The progress of a search: by its bound relative to its best, which it reaches at the end.
class SearchCount {
public:
    explicit SearchCount(std::atomic<std::int64_t>& done) : m_done(done) {}

    void note(const SearchState& state) { // on any thread
        const double share = state.best_s ? std::clamp(state.bound_s / *state.best_s, 0.0, 1.0) : 0;
        reach(std::llround(share * double(steps)));
    }
    void end() { reach(steps); }

private:
    void reach(std::int64_t count) {
        std::int64_t before = m_reached.load();
        while (before < count && !m_reached.compare_exchange_weak(before, count)) {
        }
        if (before < count) {
            m_done.fetch_add(count - before, std::memory_order_relaxed);
        }
    }

    std::atomic<std::int64_t>& m_done;
    std::atomic<std::int64_t> m_reached = 0;
};

/// The ticked options that apply to this project's search.
SearchWish wishOf(const Project& project, SearchTicks ticks) {
    const bool ofTime = objectiveOf(project) == SearchObjective::time;
    const bool ofMargin = project.optimisation->margin_within_min.has_value();
    return {.phases = ticks.phases && ofTime, .refine = ticks.refine && ofTime && !ofMargin};
}

} // namespace

void PartStudy::runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one) {
    using Surfaces = std::vector<SurfaceStudyPtr>;
    const auto work = [setup, kind, one = std::move(one)](const Means& means) {
        Setup present = setup;
        Surfaces studies;
        for (std::size_t i = 0; i < setup.surfaces.size() && !means.stop.stop_requested(); ++i) {
            auto study = std::make_shared<SurfaceStudy>();
            study->kind = kind;
            study->surface = i;
            WornProject worn = wornProject(present, i, means.stop);
            if (means.stop.stop_requested()) {
                break;
            }
            study->issues = std::move(worn.issues);
            if (study->issues.empty()) {
                one(*study, present, worn.project, means);
            }
            studies.push_back(std::move(study));
        }
        return std::pair(std::move(studies), means.stop.stop_requested());
    };
    start(parts, work, [this](const std::pair<Surfaces, bool>& result) {
        for (const SurfaceStudyPtr& study : result.first) {
            emit surfaceDone(study);
        }
        emit finished(result.second);
    });
}

void PartStudy::startBatches(const Setup& setup) {
    std::int64_t parts = 0;
    for (const GroundSurface& surface : setup.surfaces) {
        parts += surface.project.batch ? partsOf(surface.project) : 0;
    }
    runAll(setup, SurfaceStudy::Kind::batch, parts,
           [](SurfaceStudy& study, Setup&, const Project& project, const Means& means) {
               study.isSetUp = project.batch.has_value();
               if (study.isSetUp) {
                   BatchOptions options;
                   options.threads = means.threads;
                   options.stop = means.stop;
                   options.done = means.done;
                   study.batch = runWholeBatch(project, options);
               }
           });
}

void PartStudy::startSearches(const Setup& setup, SearchTicks ticks) {
    runAll(setup, SurfaceStudy::Kind::search,
           steps * static_cast<std::int64_t>(setup.surfaces.size()),
           [ticks](SurfaceStudy& study, Setup& present, const Project& worn, const Means& means) {
               SearchCount progress(*means.done);
               const Project project = worn.optimisation ? worn : usualSearch(worn);
               SearchWish wish = wishOf(project, ticks);
               wish.wear = searchWear(present, study.surface);
               study.search =
                   search(project, wish, means.stop,
                          {.note = [&progress](const SearchState& s) { progress.note(s); }});
               if (const FoundCycle* found = study.search->answer()) {
                   Project& own = present.surfaces[study.surface].project;
                   own = withFound(std::move(own), *found);
               }
               progress.end();
           });
}

namespace {

SurfaceStatus statusFrom(const SimulationResult& result,
                         const std::vector<ConstraintResult>& constraints,
                         const RemovedMetal& removed) {
    SurfaceStatus status;
    status.state = SurfaceStatus::State::ran;
    status.judgement = judge(result, constraints);
    status.time_s = result.time_s;
    status.requirements = worstByKind(constraints);
    status.isRoughnessEstimate = !isRoughnessCalibrated(result.project);
    status.isBatchComing = result.project.batch && isBatchQuick(result);
    status.removed = removed;
    return status;
}

SurfaceStatus refusedStatus() {
    SurfaceStatus status;
    status.state = SurfaceStatus::State::refused;
    return status;
}

} // namespace

bool PartRuns::Known::isOf(const Known& wanted) const {
    return surface == wanted.surface && wear == wanted.wear
           && removedBefore == wanted.removedBefore;
}

PartRuns::PartRuns(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::changed, this, &PartRuns::follow);
    m_statuses.resize(document.surfaceCount());
}

bool PartRuns::holds() const {
    return std::ranges::all_of(m_statuses, &SurfaceStatus::holds);
}

std::optional<PieceTime> PartRuns::time() const {
    double cycles_min = 0;
    for (const SurfaceStatus& status : m_statuses) {
        if (!status.isCompleted()) {
            return std::nullopt;
        }
        cycles_min += status.time_s / units::secondsPerMinute;
    }
    return pieceTime(m_document.state().times, m_statuses.size(), cycles_min);
}

void PartRuns::setJudged(const JudgedRun& judged) {
    const Outcome& outcome = *judged.outcome;
    if (m_document.surfaceCount() == 1) {
        SurfaceStatus status = refusedStatus();
        if (outcome.ran()) {
            status = statusFrom(
                outcome.result, outcome.constraints,
                removedMetal(outcome.result.project, outcome.shop.cycle.removedVolume_mm3));
            status.judgement = judged.judgement;
            status.areStocksComing = judged.areStocksComing;
            status.isBatchComing = judged.isBatchComing;
        }
        m_statuses = {std::move(status)};
        emit changed();
        return;
    }
    m_isFrontComing = judged.areStocksComing || judged.isBatchComing;
    const std::size_t surface = m_document.surface();
    const bool saysMore = judged.judgement.batch || judged.judgement.measured;
    if (outcome.ran() && saysMore && !judged.areStocksComing && surface < m_statuses.size()) {
        m_front = judged.judgement;
        if (m_statuses[surface].ran()) {
            take(surface, shownRun(surface));
        }
    }
    runNextBatch();
}

/// More may be known about the current surface.
void PartRuns::takeFront(std::size_t surface, SurfaceStatus& status) const {
    if (status.ran() && m_front && surface == m_document.surface()) {
        status.judgement = *m_front;
        status.areStocksComing = false;
        status.isBatchComing = status.isBatchComing && !(m_front->batch && m_front->batch->isWhole);
    }
}

void PartRuns::judgeBatches(bool isOn) {
    m_judgesBatches = isOn;
    if (isOn) {
        runNextBatch();
    } else {
        m_batchJob.drop();
    }
}

/// That of the current surface is run by CycleJudge; a batch does not change a surface that is
/// unfit already.
void PartRuns::runNextBatch() {
    if (!m_judgesBatches || m_running || m_isFrontComing || m_batchJob.running()) {
        return;
    }
    for (std::size_t i = 0; i < m_statuses.size(); ++i) {
        const SurfaceStatus& status = m_statuses[i];
        if (i != m_document.surface() && status.isBatchComing && status.holds()) {
            const Known run = shownRun(i);
            m_batchJob.start(
                0, [run](const Job::Means& means) { return batchOf(wornBefore(run), means); },
                [this, i, run](const BatchOutcomePtr& batch) {
                    takeBatch(i, run, batch);
                    runNextBatch();
                });
            return;
        }
    }
}

void PartRuns::takeStudy(const SurfaceStudyPtr& study) {
    const std::size_t surface = study->surface;
    if (!study->batch || surface >= m_statuses.size() || !m_statuses[surface].ran()) {
        return;
    }
    const std::optional<JudgedBatch>& before = m_statuses[surface].judgement.batch;
    Known run = shownRun(surface);
    if (!(before && before->isWhole) && sameBatch(study->batch->result.project, wornBefore(run))) {
        takeBatch(surface, std::move(run), study->batch);
    }
}

/// A batch that is refused stays not run.
void PartRuns::takeBatch(std::size_t surface, Known run, const BatchOutcomePtr& batch) {
    run.status.isBatchComing = false;
    if (batch && batch->ran() && batch->summary.parts > 0) {
        run.status.judgement =
            judgedWith(std::move(run.status.judgement), judgeBatch(batch->result, batch->summary));
    }
    take(surface, std::move(run));
}

PartRuns::Known PartRuns::wantedRun(const SetupState& state, std::size_t surface,
                                    const RemovedMetal& removed) {
    return {
        state.surfaces[surface], state.wear, state.wear.isGiven() ? removed : RemovedMetal(), {}};
}

PartRuns::Known PartRuns::shownRun(std::size_t surface) const {
    RemovedMetal removed;
    for (std::size_t i = 0; i < surface; ++i) {
        removed += m_statuses[i].removed;
    }
    Known run = wantedRun(m_document.state(), surface, removed);
    run.status = m_statuses[surface];
    return run;
}

Project PartRuns::wornBefore(const Known& run) {
    Setup one;
    one.surfaces.push_back({{}, run.surface->project});
    one.wear = run.wear;
    return wornProject(one, 0, run.removedBefore).project;
}

std::optional<SurfaceRun> PartRuns::runOf(const Known& wanted, const std::stop_token& stop) {
    const Project worn = wornBefore(wanted);
    if (!wanted.surface->open.empty() || hasErrors(validate(worn))) {
        return std::nullopt;
    }
    return runSurface({}, worn, stop);
}

/// Shows the known results; true if they are complete.
bool PartRuns::takeKnown() {
    const SetupState& state = m_document.state();
    m_statuses.assign(state.surfaces.size(), {});
    RemovedMetal removed;
    bool isAll = true;
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        const Known run = wantedRun(state, i, removed);
        const auto found =
            std::ranges::find_if(m_known, [&run](const Known& each) { return each.isOf(run); });
        if (found != m_known.end()) {
            m_statuses[i] = found->status;
            removed += found->status.removed;
        }
        isAll = isAll && found != m_known.end() && !found->status.areStocksComing;
        if (state.wear.isGiven() && !m_statuses[i].ran()) {
            break;
        }
    }
    return isAll;
}

/// With wear, surfaces after a refused one are not run.
void PartRuns::follow() {
    m_batchJob.drop();
    m_front.reset();
    m_isFrontComing = true;
    m_running = m_document.surfaceCount() > 1 && !takeKnown();
    if (m_document.surfaceCount() == 1) {
        m_statuses.assign(1, {});
    }
    if (!m_running) {
        m_job.stop();
        emit changed();
        return;
    }
    m_job.start([this, state = m_document.state(), known = m_known, counts = m_judgesBatches](
                    const std::stop_token& stop, const NewestJob::Post& post) {
        RemovedMetal removed;
        std::vector<Fresh> fresh;
        for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
            Known wanted = wantedRun(state, i, removed);
            const auto found = std::ranges::find_if(
                known, [&wanted](const Known& each) { return each.isOf(wanted); });
            if (found != known.end() && !found->status.areStocksComing) {
                wanted.status = found->status;
            } else if (std::optional<SurfaceRun> run = runOf(wanted, stop)) {
                wanted.status = statusFrom(run->result, run->constraints, run->removed());
                wanted.status.areStocksComing = true;
                fresh.push_back({i, wanted, *std::move(run)});
            } else {
                wanted.status = refusedStatus();
            }
            if (stop.stop_requested()) {
                return;
            }
            removed += wanted.status.removed;
            const bool isOver = state.wear.isGiven() && !wanted.status.ran();
            post([this, i, wanted] { take(i, wanted); });
            if (isOver) {
                break;
            }
        }
        for (Fresh& each : fresh) {
            each.known.status.judgement = judge(each.run.result, each.run.constraints,
                                                judgeStocks(each.run.result, stop), {}, {}, counts);
            each.known.status.areStocksComing = false;
            if (stop.stop_requested()) {
                return;
            }
            post([this, surface = each.surface, known = each.known] { take(surface, known); });
        }
        post([this] {
            m_running = false;
            emit changed();
            runNextBatch();
        });
    });
    emit changed();
}

void PartRuns::take(std::size_t surface, Known run) {
    takeFront(surface, run.status); // it remains when the current surface changes
    m_statuses[surface] = run.status;
    std::erase_if(m_known, [&](const Known& each) {
        const bool isGone = std::ranges::find(m_document.state().surfaces, each.surface)
                            == m_document.state().surfaces.end();
        return isGone || each.isOf(run);
    });
    m_known.push_back(std::move(run));
    emit changed();
}

} // namespace sparkout
