// SPDX-License-Identifier: GPL-3.0-or-later
// The view of sweeps: when what is run, and what becomes of it.
#include "core/format/project_file.h"
#include "core/project/number_input.h"
#include "core/study/sweep_edits.h"
#include "ui/views/sweep/sweep_axis_box.h"
#include "ui/views/sweep/sweep_curves.h"
#include "ui/views/sweep/sweep_map.h"
#include "ui/views/sweep/sweep_view.h"

#include <QProgressBar>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// Radii ground in a sweep that runs by itself: about two seconds of one processor.
constexpr double quickSweepVisits = 2e8;

} // namespace

void SweepView::showOutcome() {
    m_edited = false;
    if (latest() && latest()->ran()) {
        m_good = latest();
        const bool asked = std::exchange(m_asked, false);
        const Project& project = m_good->result.project;
        for (SweepAxisBox* box : m_axes) {
            box->show(project);
        }
        m_refused = project.sweep ? checkSweep(project) : Issues();
        noteStale();
        const bool runs = m_running && m_runner->running() && sameSweep(*m_running, project);
        if (!project.sweep) {
            forget();
        } else if (!m_refused.empty()) {
            m_runner->drop();
        } else if (stale() && !runs) {
            m_runner->drop();
            if (asked || quick()) {
                runSweep();
            }
        }
        showPresent();
    }
    showState();
    replotShown();
    emit updated();
}

void SweepView::forget() {
    m_runner->drop();
    m_sweep.reset();
    noteStale();
    showSweep();
}

void SweepView::noteStale() {
    m_sweepStale =
        !m_sweep || !m_good || !sameSweep(m_sweep->result.project, m_good->result.project);
}

bool SweepView::quick() const {
    return static_cast<double>(m_good->result.visits)
               * static_cast<double>(pointsOf(m_good->result.project))
           <= quickSweepVisits;
}

void SweepView::runSweep() {
    if (m_edited) { // the project of now is on its way
        m_asked = true;
        return;
    }
    m_running = m_good->result.project;
    m_progress->setValue(0);
    m_progress->setFormat(SweepText::progress(0, pointsOf(*m_running), -1));
    m_runner->start(*m_running);
    showState();
}

void SweepView::takeSweep(const SweepOutcomePtr& outcome) {
    const bool any =
        outcome->ran() && std::ranges::any_of(outcome->result.points, [](const SweepPoint& point) {
            return point.status != SweepStatus::pending;
        });
    if (any) {
        m_sweep = outcome;
        m_chosen.reset();
        noteStale();
        showSweep();
    }
    showState();
    emit sweepShown();
}

void SweepView::edit(const std::function<Project(Project)>& edit, const EditText& text) {
    emit editWanted(
        [this, edit](Project project) {
            Project changed = edit(project);
            m_edited = !sameProject(changed, project);
            return changed;
        },
        text);
}

void SweepView::takeValues() {
    if (m_sweep && m_chosen) {
        edit([sweep = m_sweep, point = *m_chosen](
                 Project project) { return withPoint(std::move(project), sweep->result, point); },
             {"Edit", QT_TRANSLATE_NOOP("Edit", "Take the values of a point of the sweep")});
    }
}

void SweepView::showPresent() {
    std::vector<std::optional<double>> values;
    for (std::size_t i = 0; m_sweep && i < m_sweep->result.inputs.size(); ++i) {
        const auto input =
            numberInput(m_good->result.project, m_sweep->result.inputs[i].axis.input);
        values.push_back(input ? input->value : std::nullopt);
    }
    m_curves->setPresent(values);
    m_map->setPresent(std::move(values));
}

} // namespace sparkout
