// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_runs.h"

#include "core/project/validate.h"
#include "core/quality/roughness.h"
#include "core/setup/worn_project.h"
#include "core/units.h"

#include <algorithm>
#include <utility>

namespace sparkout {

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
        }
        m_statuses = {std::move(status)};
        emit changed();
        return;
    }
    const std::size_t surface = m_document.surface();
    if (!outcome.ran() || !judged.judgement.batch || surface >= m_statuses.size()) {
        return;
    }
    m_frontOf = m_document.state().surfaces[surface];
    m_front = judged.judgement;
    takeFront(surface, m_statuses[surface]);
    for (Known& each : m_known) { // remains when the current surface changes
        if (each.surface == m_frontOf && !m_document.state().wear.isGiven()) {
            takeFront(surface, each.status);
        }
    }
    emit changed();
}

/// More may be known about the current surface.
void PartRuns::takeFront(std::size_t surface, SurfaceStatus& status) const {
    if (status.ran() && m_document.state().surfaces[surface] == m_frontOf) {
        status.judgement = m_front;
        status.areStocksComing = false;
    }
}

std::optional<SurfaceRun> PartRuns::runOf(const SetupState& state, const Known& wanted,
                                          const std::stop_token& stop) {
    Setup one;
    one.surfaces.push_back({{}, wanted.surface->project});
    one.wear = state.wear;
    const WornProject worn = wornProject(one, 0, wanted.removedBefore);
    if (!wanted.surface->open.empty() || hasErrors(validate(worn.project))) {
        return std::nullopt;
    }
    return runSurface({}, worn.project, stop);
}

/// Shows the known results; true if they are complete.
bool PartRuns::takeKnown() {
    const SetupState& state = m_document.state();
    m_statuses.assign(state.surfaces.size(), {});
    RemovedMetal removed;
    bool isAll = true;
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        const Known run{
            state.surfaces[i], state.wear, state.wear.isGiven() ? removed : RemovedMetal(), {}};
        const auto found =
            std::ranges::find_if(m_known, [&run](const Known& each) { return each.isOf(run); });
        if (found != m_known.end()) {
            m_statuses[i] = found->status;
            takeFront(i, m_statuses[i]);
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
    m_running = m_document.surfaceCount() > 1 && !takeKnown();
    if (m_document.surfaceCount() == 1) {
        m_statuses.assign(1, {});
    }
    if (!m_running) {
        m_job.stop();
        emit changed();
        return;
    }
    m_job.start([this, state = m_document.state(), known = m_known](const std::stop_token& stop,
                                                                    const NewestJob::Post& post) {
        RemovedMetal removed;
        std::vector<Fresh> fresh;
        for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
            Known wanted{
                state.surfaces[i], state.wear, state.wear.isGiven() ? removed : RemovedMetal(), {}};
            const auto found = std::ranges::find_if(
                known, [&wanted](const Known& each) { return each.isOf(wanted); });
            if (found != known.end() && !found->status.areStocksComing) {
                wanted.status = found->status;
            } else if (std::optional<SurfaceRun> run = runOf(state, wanted, stop)) {
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
            each.known.status.judgement =
                judge(each.run.result, each.run.constraints, judgeStocks(each.run.result, stop));
            each.known.status.areStocksComing = false;
            if (stop.stop_requested()) {
                return;
            }
            post([this, surface = each.surface, known = each.known] { take(surface, known); });
        }
        post([this] {
            m_running = false;
            emit changed();
        });
    });
    emit changed();
}

void PartRuns::take(std::size_t surface, Known run) {
    m_statuses[surface] = run.status;
    takeFront(surface, m_statuses[surface]);
    std::erase_if(m_known, [&](const Known& each) {
        const bool isGone = std::ranges::find(m_document.state().surfaces, each.surface)
                            == m_document.state().surfaces.end();
        return isGone || each.isOf(run);
    });
    m_known.push_back(std::move(run));
    emit changed();
}

} // namespace sparkout
