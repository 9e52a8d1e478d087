// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_runs.h"

#include "core/project/validate.h"
#include "core/quality/requirement.h"
#include "core/quality/roughness.h"
#include "core/setup/surface_run.h"
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
    status.isCompleted = result.status == RunStatus::completed;
    status.light = verdictOf(result.status, constraints);
    status.time_s = result.time_s;
    std::vector<ConstraintResult> spoken = constraints; // not of a setting within its range
    std::erase_if(spoken, [](const ConstraintResult& each) {
        return each.holds && requirementOf(each.kind).scope == ConstraintScope::setting;
    });
    if (const ConstraintResult* worst = worstRequirement(spoken)) {
        status.worst = *worst;
    }
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
        if (!status.ran() || !status.isCompleted) {
            return std::nullopt;
        }
        cycles_min += status.time_s / units::secondsPerMinute;
    }
    return pieceTime(m_document.state().times, m_statuses.size(), cycles_min);
}

void PartRuns::setOutcome(const OutcomePtr& outcome) {
    if (m_document.surfaceCount() > 1) {
        return;
    }
    m_statuses = {outcome->ran() ? statusFrom(
                      outcome->result, outcome->constraints,
                      removedMetal(outcome->result.project, outcome->shop.cycle.removedVolume_mm3))
                                 : refusedStatus()};
    emit changed();
}

SurfaceStatus PartRuns::statusOf(const SetupState& state, const Known& wanted,
                                 const std::stop_token& stop) {
    Setup one;
    one.surfaces.push_back({{}, wanted.surface->project});
    one.wear = state.wear;
    const WornProject worn = wornProject(one, 0, wanted.removedBefore);
    if (!wanted.surface->open.empty() || hasErrors(validate(worn.project))) {
        return refusedStatus();
    }
    const SurfaceRun run = runSurface({}, worn.project, stop);
    return statusFrom(run.result, run.constraints, run.removed());
}

/// Shows what is known already; true when that is all.
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
        if (found == m_known.end()) {
            isAll = false;
        } else {
            m_statuses[i] = found->status;
            removed += found->status.removed;
        }
        if (state.wear.isGiven() && !m_statuses[i].ran()) {
            break;
        }
    }
    return isAll;
}

/// Where the wheel wears, what is refused leaves those behind it not run.
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
        for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
            Known run{
                state.surfaces[i], state.wear, state.wear.isGiven() ? removed : RemovedMetal(), {}};
            const auto found =
                std::ranges::find_if(known, [&run](const Known& each) { return each.isOf(run); });
            run.status = found != known.end() ? found->status : statusOf(state, run, stop);
            if (stop.stop_requested()) {
                return;
            }
            removed += run.status.removed;
            const bool isOver = state.wear.isGiven() && !run.status.ran();
            post([this, i, run] { take(i, run); });
            if (isOver) {
                break;
            }
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
    std::erase_if(m_known, [&](const Known& each) {
        const bool isGone = std::ranges::find(m_document.state().surfaces, each.surface)
                            == m_document.state().surfaces.end();
        return isGone || each.isOf(run);
    });
    m_known.push_back(std::move(run));
    emit changed();
}

} // namespace sparkout
