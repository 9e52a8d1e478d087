// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the batch: when what is run, and what becomes of it.
#include "core/study/batch_edits.h"
#include "ui/plot/plot_pages.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/batch/batch_view.h"
#include "ui/views/batch/sensitivity_plot.h"

#include <QProgressBar>

#include <utility>

namespace sparkout {

namespace {

/// Radii ground in a batch that runs by itself: about two seconds of one processor.
constexpr double quickVisits = 2e8;
constexpr int indexPoints = 256; ///< a power of two, as the Sobol sequence wants it

} // namespace

void BatchView::showOutcome() {
    if (latest() && latest()->ran()) {
        m_good = latest();
        noteStale();
        if (!stale()) {
            m_refused.reset(); // what is shown is of these inputs
        }
        const Project& project = m_good->result.project;
        const bool runs = m_running && m_runner->running() && sameBatch(*m_running, project);
        if (!project.batch) {
            forget();
        } else if (stale() && !runs) {
            m_runner->drop();
            m_refused.reset();
            if (quick()) {
                runBatch();
            }
        }
    }
    showState();
    replotShown();
    emit updated();
}

void BatchView::forget() {
    m_runner->drop();
    m_indexRunner->drop();
    m_batch.reset();
    m_refused.reset();
    noteStale();
    showBatch();
}

void BatchView::noteStale() {
    m_batchStale =
        !m_batch || !m_good || !sameBatch(m_batch->result.project, m_good->result.project);
}

bool BatchView::quick() const {
    return static_cast<double>(m_good->result.visits)
               * static_cast<double>(partsOf(m_good->result.project))
           <= quickVisits;
}

void BatchView::runBatch() {
    if (!stale() && m_pages->page().plot == m_sensitivity
        && m_sensitivity->kind() == SensitivityKind::sobol && !m_indices) {
        runIndices();
        return;
    }
    m_running = m_good->result.project;
    m_refused.reset();
    m_progress->setValue(0);
    m_progress->setFormat(BatchText::progress(0, partsOf(*m_running), -1));
    m_runner->start(*m_running);
    showState();
}

void BatchView::takeBatch(const BatchOutcomePtr& outcome) {
    if (!outcome->ran()) {
        m_refused = outcome;
    } else if (outcome->summary.parts > 0) {
        m_batch = outcome;
        noteStale();
        m_indexRunner->drop();
        m_indices.reset();
        showBatch();
        if (wantsIndices()) {
            runIndices();
        }
    }
    showState();
    emit batchShown();
}

bool BatchView::busy() const {
    return m_runner->running() || m_indexRunner->running();
}

bool BatchView::wantsIndices() const {
    return m_pages->page().plot == m_sensitivity && m_sensitivity->kind() == SensitivityKind::sobol
           && m_batch && m_indicesOf != m_batch && !m_batch->factors.empty()
           && !m_batch->result.project.batch->correlation;
}

void BatchView::runIndices() {
    m_indicesOf = m_batch;
    m_progress->setValue(0);
    m_progress->setFormat(
        BatchText::progress(0, partsOfIndices(m_batch->result.project, indexPoints), -1));
    m_indexRunner->startIndices(m_batch->result.project, indexPoints);
    showState();
}

void BatchView::takeIndices(const SobolIndicesPtr& indices) {
    m_indices = indices;
    m_sensitivity->setIndices(m_indices);
    m_pages->showLegend();
    showState();
    replotShown();
    emit batchShown();
}

void BatchView::takeWorst() {
    if (m_batch && !stale()) {
        const auto take = [batch = m_batch](Project project) -> std::optional<Project> {
            if (!sameBatch(batch->result.project, project)) {
                return std::nullopt; // edited meanwhile
            }
            return withPart(std::move(project), batch->result, batch->summary.worstPart);
        };
        emit runWanted(take, tr("Worst part, no. %1").arg(m_batch->summary.worstPart));
    }
}

} // namespace sparkout
